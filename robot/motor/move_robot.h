// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/device/motor_drive.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Drives the robot as a force says.
///
///   reads     input_force, shaft_variable, mask_variable (bits: the pressed bumpers)
///   commands  motor_drive, in every tick: the motors stop by themselves when commands cease
///   law       f: the force, clipped to length 1, less its part towards each pressed bumper;
///             e: angle from straight ahead to f (with `reverse`, from the robot's tail to an f
///             that points backwards), counter-clockwise
///             turn rate = turning speed · clip(e / safety_range, -1, 1)
///             speed     = forward speed · f.y if |e| <= safety_range, else 0 (it turns in place)
///             at most |f| · max_distance_magnitude at a time. A pressed bumper within 90° of the
///             way that the treads would go forbids to go there; turning stays allowed.
///             Without a force that acts, or without a valid shaft, it slows down to a stand.
///   source    the paper's move_robot; the law between its parameters is our choice
class MoveRobot final : public MotorSchema {
 public:
  static void describe(Declaration<MoveRobot>& is);
  void run(const Tick& tick) override;

 private:
  [[nodiscard]] DriveCommand command(const Tick& tick) const noexcept;
  [[nodiscard]] DriveCommand follow(const Vec2& force, std::uint32_t pressed) const noexcept;

  const Variable<Force>* input_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  const Variable<Bits>* mask_ = nullptr;
  double max_distance_m_ = 0;
  double safety_range_rad_ = 0;
  bool reverse_ = false;
  const Devices* devices_ = nullptr;
};

}  // namespace galilean::robot
