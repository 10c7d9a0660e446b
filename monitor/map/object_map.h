#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/map/frames.h"

namespace galilean::monitor {

/// A thing as the team knows it.
struct MapObject {
  std::uint64_t id = 0;  ///< the same as long as it is remembered
  std::string object_class;
  Gaussian2 place;  ///< map frame
  double certainty = 0;
  Time last_seen{};
  std::vector<std::string> seen_by;  ///< robots, the latest first
  std::string held_by;               ///< the robot that carries it, or empty
};

/// Makes one list of what several robots remember: landmarks of one class that may be the same
/// thing, by Mahalanobis distance in the map frame, are one object; two landmarks of one robot
/// never are, since it saw two. What a robot carries goes with it.
class ObjectMap {
 public:
  /// Where a robot is in the map frame and whether something is in its gripper.
  struct Carrier {
    std::string robot;
    Pose2 pose;
    bool holds = false;
  };

  /// Gives the landmarks their objects' ids.
  void merge(std::map<std::string, RobotMemory>& memories, Frames& frames);
  /// After merge: what is picked up and put down since the last time.
  void carry(const std::vector<Carrier>& carriers, std::map<std::string, RobotMemory>& memories,
             Frames& frames, Time now);

  [[nodiscard]] const std::vector<MapObject>& objects() const noexcept { return objects_; }
  /// The sighting of a thing at `in_map_m` is of one that a robot carries.
  [[nodiscard]] bool is_carried(const Vec2& in_map_m) const;

 private:
  void add(const std::string& robot, Landmark& landmark, const FrameEstimate& frame);
  void pick_up(const Carrier& carrier, std::map<std::string, RobotMemory>& memories, Time now);
  void put_down(const std::string& robot, std::map<std::string, RobotMemory>& memories,
                Frames& frames, Time now);

  std::vector<MapObject> objects_;
  std::map<std::string, MapObject> held_;  ///< by robot
  std::uint64_t last_id_ = 0;
};

}  // namespace galilean::monitor
