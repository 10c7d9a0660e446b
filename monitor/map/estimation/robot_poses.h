#pragma once

#include <map>
#include <string>

#include "core/clock.h"
#include "core/geometry.h"
#include "monitor/map/estimation/gaussian.h"
#include "monitor/map/estimation/joint_gaussian.h"
#include "monitor/map/estimation/starts.h"

namespace galilean::monitor {

/// Where the robots are in the map frame: parts of the joint distribution that dead reckoning moves
/// (see RobotMotion) and sightings correct.
///
///   start  as Starts says
///   jumps  an odometer that leaps was set anew (a robot that restarted): the robot stays.
class RobotPoses {
 public:
  RobotPoses(JointGaussian& joint, const Starts& starts) : joint_(joint), starts_(starts) {}

  /// The robot believes to be at `in_odom`; something is at its bumpers or not.
  void move(const std::string& robot, const Pose2& in_odom, bool touching, Time now);

  /// Somebody said where it starts, or its frame is the map's.
  [[nodiscard]] bool was_placed(const std::string& robot) const {
    return starts_.is_given(robot) || robots_.size() == 1;
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
  const Starts& starts_;
  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
