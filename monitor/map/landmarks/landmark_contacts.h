// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/map/landmarks/landmark_store.h"

namespace galilean::monitor {

/// What it says of landmarks where the robots' bodies are.
class LandmarkContacts {
 public:
  /// Radius of a robot's footprint about its centre, in whichever direction it faces.
  static constexpr double kFootprint_m = 0.15;

  LandmarkContacts(JointGaussian& joint, const RobotPoses& robots, LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Adds an object that a robot touched or put down at `in_robot` (x forward, y left). An obstacle
  /// that is touched again is the same obstacle, and does not correct the robot.
  void add_contact(const std::string& object_class, const std::string& robot,
                   const Gaussian2& in_robot, double certainty, Time now, std::uint64_t id = 0);
  /// Inflates the landmarks near a robot that moved for `for_s`, because it may push them.
  void inflate_near(const std::string& robot, double for_s);
  /// Removes trash where a robot stands: it was pushed away, or picked up.
  void clear_footprint(const std::string& robot);
  /// The same for a robot of another group, whose position in the map frame is given.
  void clear_footprint(const Gaussian2& robot);

 private:
  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkStore& landmarks_;
};

}  // namespace galilean::monitor
