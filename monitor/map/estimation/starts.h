#pragma once

#include <map>
#include <string>

#include "core/geometry.h"

namespace galilean::monitor {

/// Where the robots' odom frames have their origins in the map frame.
///
///   law  as a person says; one of which nothing is said, as the first of which something is. Where
///        nothing is said of any, the map frame is the odom frame of the first that is heard
class Starts {
 public:
  struct Start {
    Pose2 origin;
    double position_m = 0, heading_rad = 0;  ///< standard deviations
    bool is_reference = false;               ///< its frame is the map's
  };

  void give(const std::string& robot, const Pose2& origin) { given_[robot] = origin; }
  [[nodiscard]] bool is_given(const std::string& robot) const { return given_.contains(robot); }
  /// The first that is heard refers to itself.
  void hear(const std::string& robot) {
    if (first_heard_.empty()) first_heard_ = robot;
  }
  [[nodiscard]] Start of(const std::string& robot) const;

 private:
  std::map<std::string, Pose2> given_;
  std::string first_heard_;
};

}  // namespace galilean::monitor
