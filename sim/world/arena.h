// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/scenario/scenario.h"
#include "sim/world/physics.h"

namespace galilean::sim {

/// Puts what never moves into the world: walls, tables, desks and screens.
void build_arena(const Scenario& scenario, Physics& physics);

}  // namespace galilean::sim
