// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Lets variables of the same name and type keep value, status and certainty as of `now`. How fast
/// they fade is as `to` says. A parameter of both programs takes the value of the text of `to`, so
/// that an edited constant takes effect. Pictures move from `from` to `to`, and are invalid in
/// `from`. The control loop calls it.
void carry_over(RunningProgram& from, RunningProgram& to, Time now) noexcept;

/// Returns the state in which `to` goes on: the state with the name of `from`'s state, if `to` has
/// one. Otherwise it is the state to which on_swap maps that name. Otherwise it is `to`'s current
/// state: the start state of a new program, or the state in which an old program was left.
[[nodiscard]] std::uint32_t successor_state(const RunningProgram& from,
                                            const RunningProgram& to) noexcept;
/// Does the same for a state of which only the name, `left`, is known.
[[nodiscard]] std::uint32_t successor_state(const std::string& left,
                                            const RunningProgram& to) noexcept;

}  // namespace galilean::robot
