#pragma once

#include "sim/scenario.h"
#include "sim/world/physics.h"

namespace galilean::sim {

inline constexpr double kChairLegRadius_m = 0.015;

/// Where a chair's four legs stand, arena frame.
[[nodiscard]] std::vector<Vec2> chair_legs_m(const Chair& chair);

/// Puts what never moves into the world: walls, tables, desks, screens, chair legs.
void build_arena(const Scenario& scenario, Physics& physics);

}  // namespace galilean::sim
