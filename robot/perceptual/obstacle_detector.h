// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Remembers where the robot touched something.
///
///   reads   bits_variable, shaft_variable
///   writes  obstacle_variable (locate), with the shaft's certainty, while bit `bit_index` is 1
///   law     position = `translation` from the robot's centre (robot frame), turned into the global
///           frame: the obstacle stays where it was when the robot leaves it. With the gripper's
///           beam as the bit it remembers what the gripper could not hold.
///   source  the paper
class ObstacleDetector final : public PerceptualSchema {
 public:
  static void describe(Declaration<ObstacleDetector>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
  Vec2 translation_m_ = Vec2::Zero();
  const Variable<Shaft>* shaft_ = nullptr;
  Variable<Locate>* obstacle_ = nullptr;
};

}  // namespace galilean::robot
