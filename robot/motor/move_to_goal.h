// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Pulls the robot towards a located object with the same strength from everywhere.
///
///   reads   goal_variable (locate), shaft_variable
///   writes  result (force), towards the goal, with the certainty of what it read
///   law     |F| = 1 if d > success_radius, else 0; d: from centre to centre, in metres
///   source  Arkin 1989
class MoveToGoal final : public MotorSchema {
 public:
  static void describe(Declaration<MoveToGoal>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Locate>* goal_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double success_radius_m_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
