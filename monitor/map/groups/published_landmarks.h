// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/groups/robot_groups.h"
#include "monitor/map/relocalization/labelled_point.h"

namespace galilean::monitor {

/// A landmark as the team publishes it, from the estimates of one group or several.
struct PublishedLandmark {
  /// A group's own landmark.
  struct Source {
    RobotGroup* group;
    std::uint64_t id;  ///< in the group's landmarks
  };

  std::uint64_t id = 0;  ///< the lowest among its sources
  std::string object_class;
  Gaussian2 position;  ///< map frame
  double certainty = 0;
  Time last_seen{};
  std::map<std::string, Time> seen_by;  ///< robots, and when each saw it last
  std::vector<Source> sources;          ///< at most one of each group

  [[nodiscard]] bool has(const RobotGroup& group, std::uint64_t landmark) const;
};
using PublishedLandmarks = std::vector<PublishedLandmark>;

/// Estimates of two groups that may be of one object.
struct DuplicatePair {
  std::size_t a, b;  ///< indices into the landmarks
  double squared_distance;
  bool is_sure;  ///< nothing else comes into question
};

/// Returns what each group would publish by itself.
[[nodiscard]] PublishedLandmarks landmarks_by_group(const RobotGroups& groups);
/// Returns the pairs of one class that are near one another and inside the gate, of localized
/// groups; the nearest first. `landmarks` are those of landmarks_by_group.
[[nodiscard]] std::vector<DuplicatePair> duplicate_pairs(const PublishedLandmarks& landmarks);
/// Returns the landmarks with duplicates merged, the nearest pairs first. Two landmarks of one
/// group are never merged, because the group saw them as two. A merged landmark stands where it is
/// known best: what groups learned from one another is not counted twice.
[[nodiscard]] PublishedLandmarks merged(PublishedLandmarks landmarks,
                                        const std::vector<DuplicatePair>& pairs);

/// Returns the landmarks that localized groups other than `group` know, in the map frame. `group`
/// may know them as well.
[[nodiscard]] std::vector<LabelledPoint> known_to_others(const RobotGroup& group,
                                                         const PublishedLandmarks& published);

}  // namespace galilean::monitor
