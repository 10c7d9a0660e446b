// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Pushes the robot away from another robot: the repulsion that spreads a team.
///
///   reads   robot_variable (locate), shaft_variable
///   writes  result (force), away from the other robot, with the certainty of what it read
///   law     |F| = infinite, clipped to max_repulsion if d <= min
///           |F| = (S - d) / (S - min)                if min < d < S
///           |F| = 0                                  else
///           d: from centre to centre; S = max_sphere, in metres
///   source  Arkin, as in MissionLab's library; unlike an obstacle's, S counts from the robot
class AvoidRobot final : public MotorSchema {
 public:
  static void describe(Declaration<AvoidRobot>& is);
  void run(const Tick& tick) override;

 private:
  [[nodiscard]] double strength(double distance_m) const noexcept;

  const Variable<Locate>* robot_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double min_sphere_m_ = 0;
  double max_sphere_m_ = 0;
  double max_repulsion_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
