// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"
#include "robot/variables/relative.h"

namespace galilean::robot {

/// Brings the robot to a place from a given side.
///
///   reads   dock_variable (locate), shaft_variable
///   writes  result (force), with the certainty of what it read
///   law     d: from centre to centre, in metres. phi: angle between the approach line, which leads
///           from the dock against `approach_heading`, and the line from the dock to the robot.
///           d > Rc:       1 towards the dock (ballistic)
///           stop < d <= Rc (controlled): goal part + tangential part, where
///             goal part, towards the dock: 1 if |phi| <= cone, else d / Rc
///             tangential part, across it towards the approach line: |phi| / cone if
///             |phi| <= cone, else 1
///           d <= stop:    0
///   source  Arkin and Murphy's docking, as in MissionLab's library
class Dock final : public MotorSchema {
 public:
  static void describe(Declaration<Dock>& is);
  void run(const Tick& tick) override;

 private:
  [[nodiscard]] Vec2 controlled_force(const RelativeObject& dock) const noexcept;

  const Variable<Locate>* dock_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double approach_heading_rad_ = 0;
  double controlled_radius_m_ = 0;
  double cone_rad_ = 0;
  double stop_radius_m_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
