// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "monitor/top/model/view.h"

namespace galilean::monitor::top {

// Each function fills one part of a view of the chosen robot.

/// `chosen` is the state that keys set break points at; empty: none.
void show_machine(const Robot& robot, std::string_view chosen, View& view);
/// `state_age_s` is the time since the robot's newest state was received.
void show_changes(const Robot& robot, double state_age_s, View& view);
void show_variables(const Sources& sources, const Robot& robot, std::string_view filter,
                    View& view);

/// Returns whether the text contains the part, in upper or lower case.
[[nodiscard]] bool contains(std::string_view text, std::string_view part);

}  // namespace galilean::monitor::top
