#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/map/evidence/carried.h"
#include "monitor/map/evidence/floor.h"
#include "monitor/map/evidence/senses.h"
#include "monitor/map/groups/neighbours.h"

namespace galilean::monitor {

/// What the team knows together: the floor, the landmarks on it and the robots, in one frame,
/// "map". Robots and landmarks are estimated together, a few robots at a time (Squad); the floor is
/// drawn where they are now. Pure: messages and the time go in, messages come out.
class TeamMap {
 public:
  /// `squad`: how many robots are estimated together at most.
  explicit TeamMap(Duration silent_after, std::size_t squad = Squads::kMostRobots)
      : silent_after_(silent_after), squads_(squad) {}
  TeamMap(const TeamMap&) = delete;
  TeamMap& operator=(const TeamMap&) = delete;

  /// Where a robot's odom frame has its origin in the map frame.
  void start_at(const std::string& robot, const Pose2& origin) { squads_.start_at(robot, origin); }

  void note(const msg::RobotState& state, Time now);
  void note(const msg::Sightings& frame, Time now);
  void note(const msg::Variables& variables, Time now);
  void note(const msg::Catalog& catalog, Time now);
  void note(const msg::Program& program, Time now);

  /// Lets landmarks be forgotten, be found to be the same, and be carried: before the messages are
  /// asked for.
  void update(Time now);
  /// `stamp_ns`: the same instant as `now`, since the Unix epoch.
  [[nodiscard]] msg::ObjectMap objects(Time now, std::int64_t stamp_ns) const;
  [[nodiscard]] msg::TFMessage transforms(std::int64_t stamp_ns) const;
  [[nodiscard]] const Floor& floor() const noexcept { return floor_; }

 private:
  struct Heard {
    Time at{};
    Vec2 last_stood_m = Vec2::Constant(1e9);
    Pose2 last_looked{Vec2::Constant(1e9), 0};
    Senses senses;
    Catalog catalog;
    std::optional<msg::Program> program;
    std::map<std::string, msg::Time> touched;  ///< obstacle variables, when last written
  };

  /// False: the message says nothing that can be used.
  bool move(const std::string& robot, const Pose2& in_odom, Time now);
  void look(const msg::Sightings& frame);
  void touch(const std::string& robot, const msg::Variable& obstacle, Time now);
  [[nodiscard]] std::vector<Gaussian2> robots_of_others(const Squad& squad) const;
  void align(Time now);
  void clear_footprint(const std::string& robot);
  [[nodiscard]] msg::MapRobot robot_message(const std::string& name, Time now) const;
  void put_landmarks(msg::ObjectMap& message, Time now, std::int64_t stamp_ns) const;
  void put_loads(msg::ObjectMap& message) const;

  Duration silent_after_;
  std::map<std::string, Heard> heard_;
  Squads squads_;
  Neighbours neighbours_{squads_};
  Carried carried_{squads_};
  std::vector<ToldThing> told_;  ///< since the last update
  Floor floor_;
};

}  // namespace galilean::monitor
