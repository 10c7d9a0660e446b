// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "robot/firmware/hardware.h"
#include "sim/world/broken_parts.h"
#include "sim/world/gripper.h"
#include "sim/world/treads.h"

namespace galilean::sim {

inline constexpr double kChassisLength_m = 0.43;  ///< the paper: 17 in
inline constexpr double kChassisWidth_m = 0.33;   ///< 13 in
inline constexpr double kChassisHeight_m = 0.30;

/// One robot on the floor: hull, treads, eight bumper switches, gripper. Its body's x axis points
/// ahead. It reads the board's outputs, and gives the board's inputs.
class RobotBody {
 public:
  RobotBody(Physics& physics, std::uint16_t index, const Pose2& start, const Slip& slip,
            Random random);

  [[nodiscard]] robot::firmware::Inputs inputs() const;
  void apply(const robot::firmware::Outputs& outputs);

  void before_step(double dt_s);
  /// Returns whether the gripper let go of something in this step.
  bool after_step(const std::vector<Touch>& touches);

  /// Presses switches as a hand does, until the next call.
  void push_bumpers(std::uint8_t switches) noexcept { pushed_ = switches; }

  [[nodiscard]] Pose2 pose() const noexcept { return pose_of(body_); }
  [[nodiscard]] const b2Body& body() const noexcept { return body_; }
  [[nodiscard]] Gripper& gripper() noexcept { return gripper_; }
  [[nodiscard]] const Gripper& gripper() const noexcept { return gripper_; }
  /// Returns what the board's pins say of the switches.
  [[nodiscard]] std::uint8_t bumpers() const noexcept {
    return static_cast<std::uint8_t>(((pressed_ | pushed_) & ~broken_.dead_bumpers) |
                                     broken_.stuck_bumpers);
  }
  [[nodiscard]] BrokenParts& broken() noexcept { return broken_; }
  [[nodiscard]] const BrokenParts& broken() const noexcept { return broken_; }
  /// Puts the robot at a place, where it stands still. Its hands let go of what they hold, which is
  /// no release that counts.
  void place(const Pose2& pose);
  /// Requires: the robot is in the arena. `impulse_ns` is a vector in the arena's frame.
  void push(const Vec2& impulse_ns);
  /// Returns how fast the hull would go right after such a push.
  [[nodiscard]] double speed_after_mps(const Vec2& impulse_ns) const;
  [[nodiscard]] bool powered() const noexcept { return powered_; }

 private:
  void press_switches(const std::vector<Touch>& touches);

  std::uint16_t index_;
  b2Body& body_;
  Treads treads_;
  Gripper gripper_;
  std::uint8_t pressed_ = 0;
  std::uint8_t pushed_ = 0;
  bool powered_ = false;
  BrokenParts broken_;
};

}  // namespace galilean::sim
