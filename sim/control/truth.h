// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"
#include "sim/control/pace.h"
#include "sim/world/world.h"

namespace galilean::sim {

/// Returns the true state of the world and its pace. The name, the time and the stamp are left to
/// the caller.
[[nodiscard]] msg::SimulationState truth_of(const World& world, const Pace& pace);

}  // namespace galilean::sim
