// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/geometry.h"

namespace galilean::monitor {

/// Tells which of a robot's reports of a touched obstacle say something new of the floor.
///
///   law  A touch goes on while its variable is written again within kReleased. It says nothing if
///        the robot neither drove nor turned when it began, because then something came to the
///        robot: a hand, or another robot. A touch that goes on says something new once for each
///        kStep_m that the touched place moves
class TouchEvidence {
 public:
  static constexpr double kStep_m = 0.05;
  /// A robot that did not move for so long stands still.
  static constexpr Duration kStill = std::chrono::milliseconds(500);
  static constexpr Duration kReleased = std::chrono::milliseconds(300);

  /// A robot is at `in_odom` by its odometry.
  void note_pose(const std::string& robot, const Pose2& in_odom, Time now);
  /// A robot reports by `variable` that it touched something at `in_odom_m`. Returns whether that
  /// is new evidence.
  [[nodiscard]] bool is_new(const std::string& robot, const std::string& variable,
                            const Vec2& in_odom_m, Time now);
  void forget(const std::string& robot) { robots_.erase(robot); }

 private:
  struct Touch {
    std::optional<Time> reported;
    bool came_to_robot = false;
    Vec2 counted_m = Vec2::Constant(1e9);  ///< where it last said something new
  };
  struct Robot {
    std::optional<Pose2> in_odom;
    std::optional<Time> moved;
    std::map<std::string, Touch> touches;  ///< by variable
  };

  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
