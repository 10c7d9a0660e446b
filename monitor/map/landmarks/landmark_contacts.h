// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/map/landmarks/landmark_store.h"

namespace galilean::monitor {

/// Updates landmarks by the robots' bodies: by what a robot touches, may push, or stands on.
class LandmarkContacts {
 public:
  /// Radius of a robot's footprint about its centre, in whichever direction it faces.
  static constexpr double kFootprint_m = 0.15;

  LandmarkContacts(JointGaussian& joint, const RobotPoses& robots, LandmarkStore& landmarks)
      : joint_(joint), robots_(robots), landmarks_(landmarks) {}

  /// Adds an object that a robot touched or put down at `in_robot` (x forward, y left). A contact
  /// near a known obstacle is with that obstacle, and does not correct the robot's pose.
  void add_contact(const std::string& object_class, const std::string& robot,
                   const Gaussian2& in_robot, double certainty, Time now, std::uint64_t id = 0);
  /// Makes the positions of the landmarks near a robot that moved for `for_s` less certain, because
  /// it may have pushed them.
  void inflate_near(const std::string& robot, double for_s);
  /// Removes trash where a robot stands, because the robot pushed it away or picked it up.
  void clear_footprint(const std::string& robot);
  /// Does the same for a robot of another group, whose position in the map frame is given.
  void clear_footprint(const Gaussian2& robot);

 private:
  JointGaussian& joint_;
  const RobotPoses& robots_;
  LandmarkStore& landmarks_;
};

}  // namespace galilean::monitor
