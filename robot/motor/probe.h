// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <vector>

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"
#include "robot/variables/relative.h"

namespace galilean::robot {

/// Draws the robot into open space.
///
///   reads   obstacle_variables (locate, several), shaft_variable
///   writes  result (force), with the shaft's certainty
///   law     The directions around the robot are 12 sectors of 30°, the first one centred straight
///           ahead. A sector is clear if no valid obstacle whose surface is within `range` covers
///           any of it. |F| = 1 - i/6 along the middle of the clear sector nearest to ahead, i
///           sectors away (0..6; of two alike the left one); 0 if none is clear.
///   source  Arkin's probe, as in MissionLab's library
class Probe final : public MotorSchema {
 public:
  static constexpr int kSectors = 12;

  static void describe(Declaration<Probe>& is);
  void run(const Tick& tick) override;

 private:
  using Sectors = std::bitset<kSectors>;

  [[nodiscard]] Sectors blocked_sectors(Time now) const noexcept;
  void block(Sectors& blocked, const RelativeObject& obstacle) const noexcept;

  std::vector<const Variable<Locate>*> obstacles_;
  const Variable<Shaft>* shaft_ = nullptr;
  double range_m_ = 0;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
