#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// A point of a frame that lies at `frame` in the map, in the map.
[[nodiscard]] inline Vec2 in_map(const Pose2& frame, const Vec2& in_frame_m) {
  return frame.position_m + rotated(in_frame_m, frame.heading_rad);
}
[[nodiscard]] inline Pose2 in_map(const Pose2& frame, const Pose2& in_frame) {
  return {in_map(frame, in_frame.position_m), wrap_angle(frame.heading_rad + in_frame.heading_rad)};
}
/// A point of the map, from a robot at `pose`: x forward, y left.
[[nodiscard]] inline Vec2 from_robot(const Pose2& pose, const Vec2& in_map_m) {
  return rotated(in_map_m - pose.position_m, -pose.heading_rad);
}

}  // namespace galilean::monitor
