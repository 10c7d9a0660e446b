// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/groups/published_landmarks.h"

namespace galilean::monitor {

/// The objects in the robots' grippers. A landmark that is picked up is removed from all groups'
/// maps and moves with its robot. An object that is put down beside a basket is thrown away, and
/// elsewhere it becomes a landmark again.
class CarriedObjects {
 public:
  struct Load {
    std::uint64_t id = 0;
    std::vector<std::string> seen_by;  ///< the robot that saw it last first
    bool was_known = true;  ///< whether it stood on the map; else a table's leg may break the beam
  };

  explicit CarriedObjects(RobotGroups& groups) : groups_(groups) {}

  /// Takes in whether `robot` holds an object now. `published` tells which of the groups' landmarks
  /// are one object.
  void update(const std::string& robot, bool holds, const PublishedLandmarks& published, Time now);
  /// Forgets a robot that is gone, and the object that it carried.
  void forget(const std::string& robot) { loads_.erase(robot); }
  /// Returns the positions of grippers that hold an object, in the map frame [m].
  [[nodiscard]] std::vector<Vec2> grippers_m() const;
  /// Returns whether an object seen at `in_map_m` is one in these grippers.
  [[nodiscard]] static bool is_carried(const Vec2& in_map_m, const std::vector<Vec2>& grippers_m);

  [[nodiscard]] const std::map<std::string, Load>& all() const noexcept { return loads_; }
  /// Returns the position of the robot's gripper in the map frame.
  [[nodiscard]] Gaussian2 position(const std::string& robot) const;

 private:
  void pick_up(const std::string& robot, const PublishedLandmarks& published);
  void put_down(const std::string& robot, Time now);

  RobotGroups& groups_;
  std::map<std::string, Load> loads_;  ///< by robot
};

}  // namespace galilean::monitor
