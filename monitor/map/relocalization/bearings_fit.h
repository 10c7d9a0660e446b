#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"
#include "monitor/map/relocalization/turned_robot.h"

namespace galilean::monitor {

/// Which way a robot faces, by all that one frame shows at once, where one bearing alone could be
/// of many landmarks.
///
///   reads   `seen`: from the robot, x forward, y left [m]; `known`: in the map frame [m]
///   law     of all turns within `most_rad`, the one by which most of `seen` lies on landmarks of
///   its
///           kind: each counts exp(-d² / 2), d its distance from the nearest in the measure of what
///           a camera errs in range and in bearing; a turn of `deviation_rad` costs half of one
///   clear   most of `seen` agrees, and no other turn, nor none, does nearly as well
struct BearingsFit {
  static constexpr double kDeviation_rad = 0.05;  ///< of a turn that was found

  /// By how much it faces otherwise than `pose` says [rad]; nothing if that is not clear.
  [[nodiscard]] static std::optional<double> turn(const std::vector<Mark>& seen,
                                                  const std::vector<Mark>& known, const Pose2& pose,
                                                  double deviation_rad, double most_rad);
};

}  // namespace galilean::monitor
