// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bare.h"
#include "foreign.h"

namespace galilean::wire {

// The values that the tests of decoding expect.
[[nodiscard]] const foreign_Plain& plain_sample();
[[nodiscard]] const foreign_Report& report_sample();
[[nodiscard]] const foreign_Settings& settings_sample();
[[nodiscard]] const foreign_Keyed& keyed_sample();
[[nodiscard]] const foreign_Large& large_sample();
[[nodiscard]] const foreign_msgs_msg_Cells& cells_sample();
[[nodiscard]] const other_RobotState& robot_state_sample();
[[nodiscard]] const bare_Message& bare_sample();

}  // namespace galilean::wire
