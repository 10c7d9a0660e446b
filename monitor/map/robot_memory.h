#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/map/gaussian.h"

namespace galilean::monitor {

/// Something that stands on the floor, as one robot remembers it.
struct Landmark {
  std::string object_class;  ///< trash, basket or obstacle
  Gaussian2 place;           ///< the robot's odom frame
  double certainty = 0;      ///< 0..1, at `faded`
  Time faded{};              ///< until when the decay is reckoned in
  Time last_seen{};
  std::uint64_t object_id = 0;  ///< in the team's map; 0 while it has none
};

/// What one robot saw and where, in its own odom frame.
///
///   reads   Sightings (trash and baskets; robots move, and are no landmarks), and the locate
///           variables of obstacles
///   law     a sighting belongs to the landmark of its class that is nearest by Mahalanobis
///   distance
///           and inside the gate, each landmark to one sighting of a frame at most: what is seen as
///           two stays two. Certainty c becomes 1 - (1 - c) * kDoubtKept with each sighting, falls
///           by 1 in kMemory, and by 1 in kAbsenceNoticed while its place is in somebody's plain
///           view and nothing is seen there. At 0 it is forgotten.
///   source  the paper's minute of memory; the rest is ours
class RobotMemory {
 public:
  static constexpr double kMemory_s = 60;
  static constexpr double kAbsenceNoticed_s = 1.5;
  static constexpr double kDoubtKept = 0.6;

  void see(const msg::Sightings& frame, Time now);
  /// Doubts what stands in plain view of `frame` and is not in it. `frame` may be another robot's,
  /// in this one's odom frame; `period_s` is the time since the frame before.
  void doubt_unseen(const msg::Sightings& frame, double period_s);
  /// An obstacle that was touched: a locate variable of the class obstacle.
  void touch(const msg::Variable& obstacle, Time now);
  /// Lets certainty fade until `now` and forgets what reached 0.
  void fade(Time now);
  /// `landmark` is no longer there: carried away or thrown away.
  void forget(std::uint64_t object_id);

  [[nodiscard]] std::vector<Landmark>& landmarks() noexcept { return landmarks_; }
  [[nodiscard]] const std::vector<Landmark>& landmarks() const noexcept { return landmarks_; }

 private:
  struct Match;

  [[nodiscard]] std::vector<Match> matches(const msg::Sightings& frame) const;
  void confirm(Landmark& landmark, const Gaussian2& sighting, Time now);
  void learn(const std::string& object_class, const Gaussian2& sighting, Time now);

  std::vector<Landmark> landmarks_;
};

}  // namespace galilean::monitor
