#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/groups/told_things.h"

namespace galilean::monitor {

/// What the robots have in their grippers. A landmark that is picked up leaves the floor, whoever
/// noted it, and goes with its robot; what is put down beside a basket is thrown away, elsewhere it
/// stands there again.
class Carried {
 public:
  struct Load {
    std::uint64_t id = 0;
    std::vector<std::string> seen_by;  ///< the latest first
    bool was_known = true;             ///< it stood on the map; else a leg may break the beam
  };

  explicit Carried(Squads& squads) : squads_(squads) {}

  /// Whether `robot` holds something now. `told` knows which notes are of one landmark.
  void note(const std::string& robot, bool holds, const std::vector<ToldThing>& told, Time now);
  /// Where something seen is one that a robot carries.
  [[nodiscard]] std::vector<Vec2> grippers_m() const;
  [[nodiscard]] static bool is_carried(const Vec2& in_map_m, const std::vector<Vec2>& grippers_m);

  [[nodiscard]] const std::map<std::string, Load>& all() const noexcept { return loads_; }
  [[nodiscard]] Gaussian2 place(const std::string& robot) const;

 private:
  void pick_up(const std::string& robot, const std::vector<ToldThing>& told);
  void put_down(const std::string& robot, Time now);

  Squads& squads_;
  std::map<std::string, Load> loads_;  ///< by robot
};

}  // namespace galilean::monitor
