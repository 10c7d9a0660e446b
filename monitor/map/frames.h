#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/map/frame_estimate.h"
#include "monitor/map/robot_memory.h"

namespace galilean::monitor {

/// One robot saw a robot, and this may have been it: the same point in two odom frames. Cameras do
/// not tell robots apart, so a sighting makes an encounter with each other robot; those that were
/// not meant disagree with the rest and drop out.
struct Encounter {
  std::string observer;
  std::string observed;
  Vec2 in_observer_m;
  Vec2 in_observed_m;
  std::uint64_t sighting = 0;  ///< the same for all encounters of one sighting
  Time at{};
};

/// Keeps each robot's odom frame aligned to the team's map frame, though dead reckoning drifts.
///
///   reads   what each robot remembers, and who met whom
///   writes  for each robot the transformation odom -> map with its covariance
///   law     the frame of the first robot (by name, among those that remember something) is the
///           team's. To it and to one another the others are fitted by landmarks of the same class
///           inside the gate and by encounters, robustly, and the fit corrects the estimate as a
///           Kalman filter does; between fits the covariance grows by the drift. Where that finds
///           nothing, because a frame began at an unknown place, all pairs of a class are tried,
///           and a transformation that at least kLeastForUnknown of them agree on, twice running,
///           is taken.
///   source  mrpt::tfest
class Frames {
 public:
  static constexpr std::size_t kLeastAgreeing = 3;
  static constexpr std::size_t kLeastForUnknown = 8;

  /// Where a robot's odom frame has its origin in the map. Of robots of which nothing is said, both
  /// frames are taken to be the same at the start.
  void start_at(const std::string& robot, const Pose2& origin);
  void note(Encounter encounter);
  /// Fits one robot, another one with each call.
  void align(const std::map<std::string, RobotMemory>& memories, Time now);

  [[nodiscard]] const FrameEstimate& of(const std::string& robot);

 private:
  using Memories = std::map<std::string, RobotMemory>;
  struct Tracked {
    FrameEstimate estimate;
    Time fitted{};                           ///< when a fit last agreed with the estimate
    Time drifted{};                          ///< until when the drift is reckoned in
    std::optional<FrameEstimate> candidate;  ///< of an unknown start, found once
  };

  [[nodiscard]] Tracked& tracked(const std::string& robot);
  void correct(const std::string& robot, const Memories& memories, Time now);
  void search(const std::string& robot, const Memories& memories, Time now);
  [[nodiscard]] std::vector<PointPair> pairs(const std::string& robot, const Memories& memories,
                                             bool inside_gate);
  void add_encounters(const std::string& robot, bool inside_gate, std::vector<PointPair>& pairs);

  std::map<std::string, Tracked> frames_;
  std::deque<Encounter> encounters_;
  std::string last_aligned_;
};

}  // namespace galilean::monitor
