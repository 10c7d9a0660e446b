// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/probe.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot {
namespace {

constexpr double kSector_rad = 2 * kPi / Probe::kSectors;

/// Returns the sector: 0 is ahead, and the others follow counter-clockwise. `steps` may be
/// negative.
int sector_at(int steps) noexcept {
  return ((steps % Probe::kSectors) + Probe::kSectors) % Probe::kSectors;
}

Vec2 sector_direction(int steps) noexcept {
  return unit_vector(kPi / 2 + steps * kSector_rad);
}

}  // namespace

void Probe::describe(Declaration<Probe>& is) {
  is.help("Draws the robot towards the open space that is nearest to straight ahead.");
  is.reads(&Probe::shaft_, "shaft_variable", "where the robot is");
  is.reads_all(&Probe::obstacles_, "obstacle_variables", "what may stand in the way");
  is.number(&Probe::range_m_, "range", unit::kCentimetre, 100,
            "how far an obstacle's surface may be and still block its direction")
      .range(0, 10000);
  is.writes(&Probe::result_, "result", "the force into the open");
}

void Probe::run(const Tick& tick) {
  if (!shaft_->valid_at(tick.now)) return;
  const Sectors blocked = blocked_sectors(tick.now);
  Vec2 force = Vec2::Zero();
  for (int i = 0; i <= kSectors / 2; ++i) {
    const bool left = !blocked[sector_at(i)];
    if (!left && blocked[sector_at(-i)]) continue;
    force = sector_direction(left ? i : -i) * (1 - i / 6.0);
    break;
  }
  result_->write({force}, shaft_->certainty_at(tick.now), tick.now, tick.number);
}

Probe::Sectors Probe::blocked_sectors(Time now) const noexcept {
  Sectors blocked;
  for (const auto* variable : obstacles_)
    if (const auto obstacle = relative_object(*variable, *shaft_, now)) block(blocked, *obstacle);
  return blocked;
}

void Probe::block(Sectors& blocked, const RelativeObject& obstacle) const noexcept {
  if (obstacle.distance_m - obstacle.radius_m > range_m_) return;
  if (obstacle.distance_m <= obstacle.radius_m) {
    blocked.set();
    return;
  }
  const double half_width_rad = std::asin(obstacle.radius_m / obstacle.distance_m);
  const double bearing = bearing_rad(obstacle.in_robot_m);
  const auto first = std::lround((bearing - half_width_rad) / kSector_rad);
  const auto last = std::lround((bearing + half_width_rad) / kSector_rad);
  for (auto step = first; step <= last; ++step) blocked.set(sector_at(static_cast<int>(step)));
}

}  // namespace galilean::robot
