// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"
#include "monitor/pushes/history/order_record.h"

namespace galilean::monitor {

/// Returns an order as it is kept, without outcomes.
[[nodiscard]] OrderRecord record_of(const msg::Command& command);
[[nodiscard]] OrderRecord record_of(const msg::BreakOrder& order);
[[nodiscard]] OrderRecord record_of(const msg::ProgramRollback& order);
[[nodiscard]] OrderRecord record_of(const msg::SimulationOrder& order);

/// Returns what `now` tells of a command that was given when the robot was as `before`, such as
/// "is held"; empty while it has not obeyed. A step is answered by the robot's Breaks, and has
/// none.
[[nodiscard]] std::string obedience(std::uint8_t kind, const msg::RobotState& before,
                                    const msg::RobotState& now);
/// Returns what a robot's answer to an order tells.
[[nodiscard]] std::string outcome_of(const msg::BreakAnswer& answer);
[[nodiscard]] std::string outcome_of(const msg::ProgramReply& reply);
[[nodiscard]] std::string outcome_of(const msg::SimulationEvent& event);

}  // namespace galilean::monitor
