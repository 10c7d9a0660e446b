// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "core/geometry.h"

namespace galilean::monitor {

/// The poses of the robots' odom frames in the map frame, as they are known before anything was
/// measured.
///
///   law  A robot's origin is what a person said. A robot of which nobody said anything takes the
///        origin of the robot that is first by name among those of which somebody did. Where nobody
///        said any, the map frame is the odom frame of the robot that is heard first, and the
///        others begin there
class OdomOrigins {
 public:
  struct Origin {
    Pose2 pose;                              ///< in the map frame
    double position_m = 0, heading_rad = 0;  ///< standard deviations
    bool is_reference = false;               ///< whether this odom frame is the map frame
  };

  /// Sets what a person said.
  void set(const std::string& robot, const Pose2& pose) { given_[robot] = pose; }
  [[nodiscard]] bool is_set(const std::string& robot) const { return given_.contains(robot); }
  /// Makes the first robot with which it is called the reference.
  void hear(const std::string& robot) {
    if (first_heard_.empty()) first_heard_ = robot;
  }
  [[nodiscard]] Origin of(const std::string& robot) const;

 private:
  std::map<std::string, Pose2> given_;
  std::string first_heard_;
};

}  // namespace galilean::monitor
