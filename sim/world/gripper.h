// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sim/world/physics.h"

namespace galilean::sim {

/// The two hands on the front bumper and the infrared beam between them.
/// While open, the hands are a funnel that bodies touch. When they close, they take what stands in
/// the beam and is small enough. They hold it as friction does: the hold pulls it to the pocket's
/// middle with at most `kHold_n`. A loose body comes along. A fixed one (a chair's leg) slips out
/// as the robot backs away, since its treads pull harder than the hands hold.
class Gripper {
 public:
  static constexpr double kPocket_m = 0.262;    ///< distance of the beam from the robot's centre
  static constexpr double kHalfWidth_m = 0.09;  ///< of the open hands, at the beam
  static constexpr double kReach_m = 0.30;      ///< distance of the tips from the robot's centre
  static constexpr double kHold_n = 6;
  static constexpr double kLargest_m = 0.06;  ///< the largest radius that the hands close around

  Gripper(Physics& physics, b2Body& robot);

  /// Sets the position of the servo: 0 is open, 1000 is closed.
  void set_servo(int permille);
  /// Lets go of a body that slipped out. It is called after each step of the world. Returns whether
  /// the hands let go of a body since the last call.
  bool update();
  /// Lets go of a body that is about to leave the world. `update` does not report it.
  void forget(BodyTag body);
  /// Returns whether the beam between the hands is broken. With closed hands it is broken while
  /// they hold a body.
  [[nodiscard]] bool beam_broken() const;
  [[nodiscard]] std::optional<BodyTag> held() const;
  /// Returns what the hands held before `update` reported that they let go.
  [[nodiscard]] std::optional<BodyTag> last_held() const noexcept { return last_held_; }
  [[nodiscard]] bool open() const noexcept { return servo_permille_ < kTakes_permille; }

 private:
  static constexpr int kTakes_permille = 600;

  [[nodiscard]] Vec2 centre_in_robot(b2Fixture& circle) const;
  [[nodiscard]] b2Fixture* circle_in_pocket() const;
  void let_hands_touch(std::uint16_t categories);
  void take(b2Fixture& circle);
  void release();

  Physics& physics_;
  b2Body& robot_;
  b2Fixture* hands_[2] = {nullptr, nullptr};
  b2MotorJoint* hold_ = nullptr;
  b2Fixture* held_circle_ = nullptr;
  std::optional<BodyTag> last_held_;
  bool released_ = false;
  int servo_permille_ = 0;
};

}  // namespace galilean::sim
