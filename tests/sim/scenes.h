// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "sim/world/world.h"

namespace galilean::sim {

/// Returns a 6 m x 6 m floor with one robot at (3, 3) m that faces along x, without jitter and
/// slip.
inline Scenario bare_floor() {
  Scenario scenario;
  scenario.name = "bare floor";
  scenario.arena.width_m = 6;
  scenario.arena.depth_m = 6;
  scenario.starts = {{{3, 3}, 0}};
  scenario.start_jitter_m = 0;
  scenario.start_jitter_rad = 0;
  scenario.slip = {0, 0, 0, 0, 0};
  return scenario;
}

inline std::unique_ptr<World> world_of(const Scenario& scenario, std::uint64_t seed = 1) {
  auto world = World::make(scenario, scenario.starts.size(), seed);
  return world ? std::move(world).value() : nullptr;
}

/// Steps the world with these outputs of the board for `seconds`.
inline void run(World& world, const robot::firmware::Outputs& outputs, double seconds) {
  for (int i = 0; i < seconds / World::kStep_s; ++i) {
    world.robot(0).apply(outputs);
    world.step();
  }
}

}  // namespace galilean::sim
