#pragma once

#include <map>
#include <string>

#include "core/clock.h"
#include "core/geometry.h"
#include "monitor/map/gaussian.h"
#include "monitor/map/joint_gaussian.h"

namespace galilean::monitor {

/// Where the robots are in the map frame: parts of the joint distribution that dead reckoning moves
/// (see RobotMotion) and sightings correct.
///
///   start  as given; else where the odom frame of the first that was given, or heard, has its
///          origin. If none is given, the map frame is the odom frame of the first that is heard.
///   jumps  an odometer that leaps was set anew (a robot that restarted): the robot stays.
class RobotPoses {
 public:
  explicit RobotPoses(JointGaussian& joint) : joint_(joint) {}

  /// Where a robot's odom frame has its origin in the map frame, as a person places it.
  void start_at(const std::string& robot, const Pose2& origin) { starts_[robot] = origin; }
  /// The robot believes to be at `in_odom`; something is at its bumpers or not.
  void move(const std::string& robot, const Pose2& in_odom, bool touching, Time now);

  /// Somebody said where it starts, or its frame is the map's.
  [[nodiscard]] bool was_placed(const std::string& robot) const {
    return starts_.contains(robot) || robots_.size() == 1;
  }
  [[nodiscard]] bool knows(const std::string& robot) const { return robots_.contains(robot); }
  [[nodiscard]] JointGaussian::Part part(const std::string& robot) const {
    return robots_.at(robot).part;
  }
  [[nodiscard]] Pose2 pose(const std::string& robot) const;
  [[nodiscard]] Gaussian2 position(const std::string& robot) const;
  [[nodiscard]] Time moved(const std::string& robot) const { return robots_.at(robot).moved; }
  /// Where the robot's odom frame lies in the map frame.
  [[nodiscard]] Pose2 frame(const std::string& robot) const;

  struct Robot {
    JointGaussian::Part part = 0;
    Pose2 in_odom;
    Time moved{};
    bool touching = false;
  };
  [[nodiscard]] const std::map<std::string, Robot>& all() const noexcept { return robots_; }

 private:
  void place(const std::string& robot, const Pose2& in_odom, Time now);

  JointGaussian& joint_;
  std::map<std::string, Pose2> starts_;
  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
