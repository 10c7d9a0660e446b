#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "monitor/map/groups/squad.h"

namespace galilean::monitor {

/// The team in squads.
///
///   law  a robot joins the squad with room whose robots are nearest when it is first heard, and
///        stays in it; beyond kNear_m it founds one. The first squad takes any, so that a team that
///        fits into it is never divided
class Squads {
 public:
  static constexpr std::size_t kMostRobots = 4;
  static constexpr double kNear_m = 8;

  explicit Squads(std::size_t most_robots) : most_robots_(most_robots) {}
  Squads(const Squads&) = delete;
  Squads& operator=(const Squads&) = delete;

  /// Where a robot's odom frame has its origin in the map frame.
  void start_at(const std::string& robot, const Pose2& origin) { starts_.give(robot, origin); }

  [[nodiscard]] bool know(const std::string& robot) const { return squad_of_.contains(robot); }
  /// Of one that is known.
  [[nodiscard]] Squad& of(const std::string& robot) const { return *squad_of_.at(robot); }
  /// Of one that believes to be at `in_odom`, and may be new.
  Squad& join(const std::string& robot, const Pose2& in_odom);

  /// Those with landmarks that may be so near; none where it cannot be told.
  [[nodiscard]] std::vector<Squad*> others_near(const Squad& squad, const Vec2& at_m,
                                                double within_m) const;
  [[nodiscard]] const std::vector<std::unique_ptr<Squad>>& all() const noexcept { return squads_; }
  [[nodiscard]] const std::map<std::string, Squad*>& robots() const noexcept { return squad_of_; }
  [[nodiscard]] std::uint64_t next_id() noexcept { return ids_.next(); }

 private:
  [[nodiscard]] Squad* nearest_with_room(const Vec2& at_m) const;

  std::size_t most_robots_;  ///< a squad
  Starts starts_;
  LandmarkIds ids_;
  std::vector<std::unique_ptr<Squad>> squads_;
  std::map<std::string, Squad*> squad_of_;  ///< by robot
};

}  // namespace galilean::monitor
