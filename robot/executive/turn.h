// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/executive/executive.h"

namespace galilean::robot {

/// Blocks until no program waits for its first tick, so that another one can be loaded. Returns
/// false if that takes more than a second, which means that the control loop stands still.
/// Requires: the caller is not the control loop.
[[nodiscard]] bool wait_for_turn(const Executive& executive);

}  // namespace galilean::robot
