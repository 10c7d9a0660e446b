// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Variables of the same name and type keep value, status and certainty as of `now`; how fast they
/// fade is as `to` says. A parameter of both programs (nothing writes it in either) takes the value
/// of the text of `to`, so that an edited constant takes effect. Pictures are taken from `from`,
/// which has none then. Belongs to the control loop.
void carry_over(RunningProgram& from, RunningProgram& to, Time now) noexcept;

/// Where `to` goes on: in the state that `from` is in, if it has one of that name; else where its
/// on_swap sends that state; else in its own current state, which is the start state of a new
/// program and the one it was left in of an old one.
[[nodiscard]] std::uint32_t successor_state(const RunningProgram& from,
                                            const RunningProgram& to) noexcept;
/// Does the same for a state of which only the name, `left`, is known.
[[nodiscard]] std::uint32_t successor_state(const std::string& left,
                                            const RunningProgram& to) noexcept;

}  // namespace galilean::robot
