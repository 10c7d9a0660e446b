// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/reader.h"
#include "robot/executive/break_point.h"

namespace galilean::robot {

/// Returns whether the command could move a robot, so that it needs a signature. Holding a robot
/// and taking it out of service need none: who sees a robot go wrong must be able to stop it.
[[nodiscard]] bool can_move(const msg::Command& command) noexcept;
/// Returns whether the order could move a robot with these break points: all orders but a set of
/// points that stop, and that have no change of state in common with them.
[[nodiscard]] bool can_move(const msg::BreakOrder& order, const std::vector<BreakPoint>& points);

/// Returns what the order is, such as "A resume".
[[nodiscard]] std::string what_is(const msg::Command& command);
[[nodiscard]] std::string what_is(const msg::BreakOrder& order);
[[nodiscard]] std::string what_is(const msg::ProgramPush& push);
[[nodiscard]] std::string what_is(const msg::ProgramRollback& order);

/// Returns who sent something, such as "'monitor' (192.168.1.7)".
[[nodiscard]] std::string words_of(const std::optional<wire::Sender>& sender);

}  // namespace galilean::robot
