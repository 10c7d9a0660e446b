// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Reads "grab" (on entering it), "wander:grab", "wander:" (on leaving it) or ":grab". Returns the
/// two states, of which one may be empty; both are if the text names none.
[[nodiscard]] msg::BreakPoint place_in(std::string_view text);

/// Returns "at wander -> grab", "on entering grab" or "on leaving wander".
[[nodiscard]] std::string place_of(const msg::BreakPoint& point);
/// Returns what the point does, such as "stops on entering grab".
[[nodiscard]] std::string rule_of(const msg::BreakPoint& point);
/// Returns what stopped the robot, and whose it is, such as "break point wander -> grab (Anna)".
/// Returns an empty text if neither a break point nor a step did.
[[nodiscard]] std::string reason_of(const msg::Breaks& told);
/// Returns all that the robot told about break points, a sentence a line.
[[nodiscard]] std::vector<std::string> lines_of(const msg::Breaks& told);
/// Returns what an order did to a robot that carried it out.
[[nodiscard]] std::string effect_of(const msg::BreakOrder& order);
/// Returns the states that the order names and the program does not have.
[[nodiscard]] std::vector<std::string> unknown_states(const msg::BreakOrder& order,
                                                      const msg::Program& program);

}  // namespace galilean::monitor
