// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"
#include "monitor/map/relocalization/labelled_point.h"

namespace galilean::monitor {

/// Finds a robot's heading from all objects in one frame. A single object could be any of its
/// class; several together are seldom confused.
///
///   reads   `seen` in the robot frame (x forward, y left), `known` in the map frame
///   law     Of all turns within `max_rad`, the one by which most of `seen` lies on known points of
///           its label. Each seen point counts exp(-d² / 2), where d is its distance from the
///           nearest known point in units of the camera's errors in range and across. A turn of
///           `deviation_rad`, the standard deviation of the heading, costs half a point
///   clear   Most of `seen` agrees, and no other turn, nor none, does nearly as well
struct HeadingFit {
  static constexpr double kDeviation_rad = 0.05;  ///< standard deviation of a turn that was found

  /// Returns by how much the robot is turned against `pose` [rad]. Nothing if that is not clear.
  [[nodiscard]] static std::optional<double> find_turn(const std::vector<LabelledPoint>& seen,
                                                       const std::vector<LabelledPoint>& known,
                                                       const Pose2& pose, double deviation_rad,
                                                       double max_rad);
};

}  // namespace galilean::monitor
