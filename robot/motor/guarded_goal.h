// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Pulls the robot towards a located object, more gently once it is near.
///
///   reads   goal_variable (locate), shaft_variable
///   writes  result (force), towards the goal, with the certainty of what it read
///   law     |F| = 1                           if d > drop
///           |F| = (d - dead) / (drop - dead)  if dead < d <= drop
///           |F| = 0                           else
///           d: from centre to centre; drop = drop_radius, dead = dead_radius, in metres
///   source  MissionLab's guarded move_to_goal; Clay's linear attraction (drop = c, dead = z)
class GuardedGoal final : public MotorSchema {
 public:
  static void describe(Declaration<GuardedGoal>& is);
  void run(const Tick& tick) override;

 private:
  [[nodiscard]] double strength(double distance_m) const noexcept;

  const Variable<Locate>* goal_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double drop_radius_m_ = 0;
  double dead_radius_m_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
