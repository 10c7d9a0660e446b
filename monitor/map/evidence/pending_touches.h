// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/map/estimation/motion_model.h"
#include "monitor/map/estimation/robot_poses.h"

namespace galilean::monitor {

/// Keeps what robots touched until its place is known as well as it ever will be. A robot that
/// touches something often does not know where it is, and recognizes a landmark a metre later.
///
///   law      The place of a touch is the robot's pose now, minus the way that its odometer counted
///            since. Its covariance is that of the pose plus that of the way, which the motion
///            model adds up
///   settled  A touch is settled when its place is known to kKnown_m, when the way since then is
///            less certain than the best place so far, or after kLongest. It then stands at the
///            best place
class PendingTouches {
 public:
  static constexpr double kKnown_m = 0.04;  ///< a standard deviation
  static constexpr Duration kLongest = std::chrono::seconds(20);

  /// `robot` touched something at `in_odom_m` (its odom frame). Requires: poses.contains(robot).
  void add(const std::string& robot, const Vec2& in_odom_m, const RobotPoses& poses, Time now);
  /// `poses` has a new pose of `robot`. Returns its touches that are settled (map frame), and
  /// forgets them. Requires: poses.contains(robot).
  [[nodiscard]] std::vector<Gaussian2> take_settled(const std::string& robot,
                                                    const RobotPoses& poses, Time now);

 private:
  struct Touch {
    Vec2 in_odom_m;
    RobotMatrix way;  ///< covariance of the robot's state since the touch (odom frame)
    Gaussian2 best;   ///< in the map frame
    Time at;
  };
  struct Robot {
    Pose2 in_odom;
    std::vector<Touch> touches;
  };

  static void move(Robot& robot, const RobotPoses::Robot& to);
  /// Returns whether the touch is settled.
  [[nodiscard]] static bool look_again(Touch& touch, const std::string& robot,
                                       const RobotPoses& poses, Time now);

  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
