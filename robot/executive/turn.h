// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/executive/executive.h"

namespace galilean::robot {

/// Waits until no program waits for its first tick, so that another one can be loaded; any thread
/// but control. False if that takes a second: the control loop stands still.
[[nodiscard]] bool wait_for_turn(const Executive& executive);

}  // namespace galilean::robot
