// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// Transforms a point [m] from a frame into the map frame. `frame` is the frame's pose in the map.
[[nodiscard]] inline Vec2 in_map(const Pose2& frame, const Vec2& in_frame_m) {
  return frame.position_m + rotated(in_frame_m, frame.heading_rad);
}
/// Transforms a pose from a frame into the map frame. `frame` is the frame's pose in the map.
[[nodiscard]] inline Pose2 in_map(const Pose2& frame, const Pose2& in_frame) {
  return {in_map(frame, in_frame.position_m), wrap_angle(frame.heading_rad + in_frame.heading_rad)};
}
/// Transforms a point [m] from the map frame into the frame of a robot at `pose` (x forward, y
/// left).
[[nodiscard]] inline Vec2 in_robot(const Pose2& pose, const Vec2& in_map_m) {
  return rotated(in_map_m - pose.position_m, -pose.heading_rad);
}

}  // namespace galilean::monitor
