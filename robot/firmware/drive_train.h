// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/firmware/hardware.h"
#include "robot/firmware/messages.h"
#include "robot/firmware/wheel.h"

namespace galilean::robot::firmware {

/// Both motors, and the timers that stop them. The timers are here, below the protocol, so that no
/// code above can forget them. `step` brakes both motors if neither `drive` nor `keep_driving` came
/// for kStopTimer_ms, and if no `drive` came for the parameters' timeout. An old target cannot
/// drive on.
class DriveTrain {
 public:
  /// A robot that is lost at full speed (30.8 cm/s) travels 3.4 cm in this time and 1 cm while it
  /// brakes. Of the commands that come at 20 Hz one may be lost.
  static constexpr std::uint32_t kStopTimer_ms = 110;

  /// Sets the parameters. Returns false, and changes nothing, if a value is not finite or not
  /// usable.
  [[nodiscard]] bool set(const Parameters& parameters);
  bool configured() const { return configured_; }

  /// Starts a motion in which both wheels reach their speeds at the same time. Speeds above the
  /// parameters' are reduced, both by the same factor, so that the curve stays.
  void drive(const Drive& command, std::uint32_t now_ms);
  /// Says that the motion under way is still wanted. After the motors were stopped it has no
  /// effect.
  void keep_driving(std::uint32_t now_ms) { last_heard_ms_ = now_ms; }
  /// Brakes both motors as fast as they can, and forgets the motion.
  void brake();
  /// Runs one period of the loops, and writes both PWM values. Speeds are measured by `now_ms`.
  /// Profiles and loops advance by `dt_s`.
  void step(const Inputs& inputs, std::uint32_t now_ms, float dt_s, Outputs& outputs);
  void start_at(const Inputs& inputs, std::uint32_t now_ms);

  bool active() const { return left_.active() || right_.active(); }
  bool stopped_by_timeout() const { return stopped_by_timeout_; }
  float left_speed_counts_s() const { return left_.measured_counts_s(); }
  float right_speed_counts_s() const { return right_.measured_counts_s(); }

 private:
  void watch(std::uint32_t now_ms);
  float allowed_speed(float left, float right) const;

  Parameters parameters_;
  bool configured_ = false;
  Wheel left_;
  Wheel right_;
  std::uint32_t last_drive_ms_ = 0;
  std::uint32_t last_heard_ms_ = 0;
  bool stopped_by_timeout_ = false;
};

}  // namespace galilean::robot::firmware
