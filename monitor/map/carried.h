#pragma once

#include <map>
#include <string>

#include "monitor/map/things.h"

namespace galilean::monitor {

/// What the robots have in their grippers. A thing that is picked up leaves the floor and goes with
/// its robot; what is put down beside a basket is thrown away, elsewhere it stands there again.
class Carried {
 public:
  struct Load {
    std::uint64_t id = 0;
    std::vector<std::string> seen_by;  ///< the latest first
    bool was_known = true;             ///< it stood on the map; else a leg may break the beam
  };

  /// Whether `robot` holds something now.
  void note(const std::string& robot, bool holds, const RobotPoses& robots, Things& things,
            Time now);
  /// The sighting of a thing at `in_map_m` is of one that a robot carries.
  [[nodiscard]] bool is_carried(const Vec2& in_map_m, const RobotPoses& robots) const;

  [[nodiscard]] const std::map<std::string, Load>& all() const noexcept { return loads_; }
  [[nodiscard]] static Gaussian2 place(const std::string& robot, const RobotPoses& robots);

 private:
  void pick_up(const std::string& robot, const RobotPoses& robots, Things& things);
  void put_down(const std::string& robot, const RobotPoses& robots, Things& things, Time now);

  std::map<std::string, Load> loads_;  ///< by robot
};

}  // namespace galilean::monitor
