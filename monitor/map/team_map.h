#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/map/floor.h"
#include "monitor/map/frames.h"
#include "monitor/map/grasp.h"
#include "monitor/map/object_map.h"

namespace galilean::monitor {

/// What the team knows together: the floor, the things on it and the robots, in one frame, "map".
/// Pure: messages and the time go in, messages come out.
class TeamMap {
 public:
  explicit TeamMap(Duration silent_after) : silent_after_(silent_after) {}

  /// Where a robot's odom frame has its origin in the map frame.
  void start_at(const std::string& robot, const Pose2& origin) { frames_.start_at(robot, origin); }

  void note(const msg::RobotState& state, Time now);
  void note(const msg::Sightings& frame, Time now);
  void note(const msg::Variables& variables, Time now);
  void note(const msg::Catalog& catalog, Time now);
  void note(const msg::Program& program, Time now);

  /// Lets things be forgotten, frames be aligned and landmarks become objects: before the messages
  /// are asked for.
  void update(Time now);
  /// `stamp_ns`: the same instant as `now`, since the Unix epoch.
  [[nodiscard]] msg::ObjectMap objects(Time now, std::int64_t stamp_ns);
  [[nodiscard]] msg::TFMessage transforms(std::int64_t stamp_ns);
  [[nodiscard]] const Floor& floor() const noexcept { return floor_; }

 private:
  struct Mapped {
    Pose2 in_odom;
    bool placed = false;  ///< it has told where it is
    Time heard{};
    Time posed{};
    Time last_frame{};
    Vec2 last_stood_m = Vec2::Constant(1e9);
    Grasp grasp;
    Catalog catalog;
    std::optional<msg::Program> program;
    std::map<std::string, msg::Time> touched;  ///< obstacle variables, when last written
  };

  /// What one robot sees no more, the others need not remember either.
  void doubt_together(const msg::Sightings& things, Time now);
  void meet(const std::string& observer, const msg::Sighting& sighting, Time now);
  [[nodiscard]] msg::MapRobot robot_message(const std::string& name, const Mapped& robot, Time now);

  Duration silent_after_;
  std::map<std::string, Mapped> robots_;
  std::map<std::string, RobotMemory> memories_;
  Frames frames_;
  ObjectMap object_map_;
  Floor floor_;
  std::uint64_t sightings_of_robots_ = 0;
  Time aligned_{};
};

}  // namespace galilean::monitor
