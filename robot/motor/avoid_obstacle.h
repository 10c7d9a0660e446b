// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Pushes the robot away from one remembered obstacle.
///
///   reads   obstacle_variable (locate), shaft_variable
///   writes  result (force), away from the obstacle, with the certainty of what it read
///   law     |F| = max_repulsion                           if d <= min
///           |F| = max_repulsion · (max - d) / (max - min) if min < d < max
///           |F| = 0                                       else
///           d: from the robot's centre to the obstacle's, less the obstacle's radius, in metres
///   source  Arkin 1989 with the three parameters of the 1994 program; Arkin's R is the obstacle's
///           radius + min, his S is max - min
class AvoidObstacle final : public MotorSchema {
 public:
  static void describe(Declaration<AvoidObstacle>& is);
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
