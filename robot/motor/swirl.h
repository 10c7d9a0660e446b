// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Leads the robot around an obstacle instead of back from it.
///
///   reads   obstacle_variable (locate), shaft_variable
///   writes  result (force), square to the obstacle's direction, with the certainty of what it read
///   law     |F| as avoid_obstacle; direction: away from the obstacle, turned +90° if the obstacle
///           is straight ahead or to the left, -90° if it is to the right. So the force never
///           points behind the robot: what is on the left is passed on its right.
///   source  Arkin's family of avoid schemas (MissionLab, TeamBots)
class Swirl final : public MotorSchema {
 public:
  static void describe(Declaration<Swirl>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Locate>* obstacle_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double min_sphere_m_ = 0;
  double max_sphere_m_ = 0;
  double max_repulsion_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
