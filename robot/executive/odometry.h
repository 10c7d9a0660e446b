// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/comm_port.h"
#include "core/schema/schema.h"
#include "robot/executive/running_program.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Dead reckoning on both motor shafts, into every shaft variable of a program.
///
///   reads   travel s_l, s_r of both wheels since the last tick [m]; r, half the track [m]
///   law     d = (s_l + s_r) / 2, a = (s_r - s_l) / 2r: the way is an arc, and so
///           position += d · sin(a/2) / (a/2) · unit vector(heading + a/2),  heading += a
///   note    a board that restarted counts anew, and so does this. A shaft that a condition reset
///           starts over from the position and heading of the program's text.
class Odometry {
 public:
  /// Updates the shafts. While the line is down they stay as they are, and their certainty fades.
  void update(const Devices& devices, RunningProgram* program, const Tick& tick) noexcept;

  /// Returns the first shaft of the program. Without a shaft it returns the robot's pose from its
  /// start.
  [[nodiscard]] Pose2 pose(const RunningProgram* program) const noexcept;
  /// Return the robot's speed and turning rate, whether or not its program has a shaft. While the
  /// line is down they are 0.
  [[nodiscard]] double speed_mps() const noexcept { return own_.speed_mps; }
  [[nodiscard]] double turn_rate_radps() const noexcept { return own_.turn_rate_radps; }

  void keep(Memory& memory) noexcept;

 private:
  struct Travel {
    double left_m = 0;
    double right_m = 0;
    std::uint32_t epoch = 0;
  };

  [[nodiscard]] Travel since_last(const ControllerStatus& status) noexcept;

  bool started_ = false;
  Travel last_;
  Shaft own_;
};

}  // namespace galilean::robot
