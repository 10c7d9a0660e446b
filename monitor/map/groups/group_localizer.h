// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "monitor/map/groups/published_landmarks.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Finds where in the map frame a group is of which nobody said where it starts.
///
///   law     All landmarks of the group are matched with those that other groups publish, by the
///           rigid transformation on which most agree. A transformation on which at least
///           kLeastAgreeing agree, twice in a row, moves the whole group
class GroupLocalizer {
 public:
  static constexpr std::size_t kLeastAgreeing = 8;

  explicit GroupLocalizer(RobotGroups& groups) : groups_(groups) {}

  /// Tries one group, another one with each call. Requires: at least one group.
  void localize_next(const PublishedLandmarks& published);
  /// Forgets what was found of a group that is dissolved.
  void forget(const RobotGroup& group) { candidates_.erase(&group); }

 private:
  void localize(RobotGroup& group, const PublishedLandmarks& published);

  RobotGroups& groups_;
  std::size_t next_ = 0;
  std::map<const RobotGroup*, RigidFit> candidates_;  ///< by group: what was found once
};

}  // namespace galilean::monitor
