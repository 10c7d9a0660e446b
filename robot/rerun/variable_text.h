// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/executive/guarded_drive.h"
#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Returns a number with all digits that tell it from its neighbours.
[[nodiscard]] std::string exact(double number);

/// Returns "locate 'trash': valid, certainty 1 at 12.35 s, x_m 0.5, …" of the variable at `index`
/// in the order of the store. `index` may be too large: then the text is empty.
[[nodiscard]] std::string variable_text(const RunningProgram& program, std::size_t index);

/// Returns "speed_mps 0.3, turn_rate_radps 0, … (1 order)", "to stop (1 order)" or "nothing".
[[nodiscard]] std::string motion_text(const MotionOrders& orders);

}  // namespace galilean::robot
