// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "core/clock.h"
#include "core/geometry.h"
#include "monitor/map/estimation/gaussian.h"
#include "monitor/map/estimation/joint_gaussian.h"
#include "monitor/map/estimation/odom_origins.h"

namespace galilean::monitor {

/// The robots of a joint distribution. Dead reckoning predicts their poses (see motion_model.h),
/// and measurements correct them. Poses are in the map frame unless the name says otherwise.
///
///   start  A robot begins where OdomOrigins says
///   jumps  An odometer that leaps was reset, because the robot was restarted. The robot then stays
///          where it is on the map
class RobotPoses {
 public:
  RobotPoses(JointGaussian& joint, const OdomOrigins& origins) : joint_(joint), origins_(origins) {}

  /// Predicts the robot's pose from its odometry. `in_odom` is its pose in its odom frame, and
  /// `touching` tells whether something is at its bumpers. Adds a robot that is new.
  void predict(const std::string& robot, const Pose2& in_odom, bool touching, Time now);

  [[nodiscard]] bool contains(const std::string& robot) const { return robots_.contains(robot); }
  /// Returns whether somebody said where the robot starts, or its odom frame is the map frame.
  [[nodiscard]] bool has_known_start(const std::string& robot) const {
    return origins_.is_set(robot) || robots_.size() == 1;
  }

  // Requires for all of the following: contains(robot).
  [[nodiscard]] JointGaussian::Block block(const std::string& robot) const {
    return robots_.at(robot).block;
  }
  /// Marginalizes the robot out of the joint distribution.
  void remove(const std::string& robot);
  [[nodiscard]] Pose2 pose(const std::string& robot) const;
  [[nodiscard]] Gaussian2 position(const std::string& robot) const;
  /// Returns where in the map frame a point of the robot's odom frame is, as uncertain as the
  /// robot's pose makes it.
  [[nodiscard]] Gaussian2 place(const std::string& robot, const Vec2& in_odom_m) const;
  /// Returns when the robot's odometry was heard last.
  [[nodiscard]] Time last_predicted(const std::string& robot) const {
    return robots_.at(robot).last_predicted;
  }
  /// Returns the pose of the robot's odom frame in the map frame.
  [[nodiscard]] Pose2 odom_frame(const std::string& robot) const;

  struct Robot {
    JointGaussian::Block block = 0;
    Pose2 in_odom;
    Time last_predicted{};
    bool touching = false;
  };
  [[nodiscard]] const std::map<std::string, Robot>& all() const noexcept { return robots_; }

 private:
  void add(const std::string& robot, const Pose2& in_odom, Time now);

  JointGaussian& joint_;
  const OdomOrigins& origins_;
  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
