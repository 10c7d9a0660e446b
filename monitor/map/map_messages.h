// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"
#include "monitor/map/evidence/carried_objects.h"
#include "monitor/map/evidence/robot_reports.h"

namespace galilean::monitor {

/// The parts of the map from which its messages are made.
struct MapContents {
  const RobotGroups& groups;
  const PublishedLandmarks& landmarks;
  const CarriedObjects& carried;
  const RobotReports& reports;
};

/// Returns published landmarks, carried objects and robots, in the map frame. A robot that was not
/// heard for `silent_after` is marked as silent. `stamp_ns` is the instant `now` since the Unix
/// epoch.
[[nodiscard]] msg::ObjectMap objects_message(const MapContents& map, Duration silent_after,
                                             Time now, std::int64_t stamp_ns);
/// Returns the pose of each robot's odom frame in the map frame.
[[nodiscard]] msg::TFMessage transforms_message(const RobotGroups& groups, std::int64_t stamp_ns);

}  // namespace galilean::monitor
