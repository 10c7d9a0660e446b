// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/map/estimation/joint_gaussian.h"

namespace galilean::monitor {

/// An object on the floor as the team remembers it. Its position is a block of the joint
/// distribution. Its certainty says how likely it is that the object is still there.
///
///   law     Each sighting replaces the certainty c by 1 - (1 - c) · kDoubtFactor, and c falls by 1
///           in kMemory_s. At 0 the landmark is no longer published, but it is kept until
///           kRetention_s after its last sighting, because a robot can still find its way by it. It
///           expires when its position was in a camera's visible area for long enough and nothing
///           was seen there. A landmark with fewer than kConfirmingSightings sightings may be a
///           trick of the light: it is not published, and it expires when c is 0
///   source  The memory of one minute is the paper's. Confirmation after a number of sightings is
///           track confirmation (Bar-Shalom, Li, Kirubarajan 2001). The rest is ours
struct Landmark {
  static constexpr double kMemory_s = 60;
  static constexpr double kRetention_s = 900;
  static constexpr double kDoubtFactor = 0.6;
  static constexpr unsigned kConfirmingSightings = 3;
  /// A landmark that only one robot saw is recent for this long after its first sighting.
  static constexpr Duration kRecent = std::chrono::seconds(12);
  /// What a robot saw within this time counts as seen now. It is shorter than kRecent, because a
  /// robot that lost its way sees again what it knew before.
  static constexpr Duration kObservationWindow = std::chrono::seconds(10);

  std::uint64_t id = 0;  ///< stays the same for as long as the landmark is remembered
  std::string object_class;
  JointGaussian::Block block = 0;
  Time first_seen{};
  Time last_seen{};
  Time decayed_until{};  ///< the decay up to this time is in `certainty`
  double certainty = 0;
  unsigned sightings = 0;
  double absent_s = 0;                  ///< how long its position was visible and empty
  std::map<std::string, Time> seen_by;  ///< robots, and when each saw it last

  /// Counts a sighting by `robot`.
  void observe(const std::string& robot, Time now);
  void decay(Time now);
  /// Lowers the certainty, because the position was visible and empty for `for_s`.
  void penalize(double for_s);
  /// Takes over what is known of `other`, which is a landmark of the same object.
  void merge(const Landmark& other);

  [[nodiscard]] bool is_expired(Time now) const noexcept;
  [[nodiscard]] bool is_confirmed() const noexcept {
    return sightings >= kConfirmingSightings || object_class == "obstacle";
  }
  [[nodiscard]] bool is_publishable() const noexcept { return is_confirmed() && certainty > 0; }
  /// Returns whether `robot` alone saw it, and only recently for the first time. It may then be a
  /// duplicate of an older landmark, added by a robot whose pose is wrong.
  [[nodiscard]] bool is_recent_of(const std::string& robot, Time now) const {
    return now - first_seen < kRecent && seen_by.size() == 1 && was_seen_by(robot);
  }
  [[nodiscard]] bool was_seen_by(const std::string& robot) const { return seen_by.contains(robot); }
  [[nodiscard]] bool was_seen_by(const std::string& robot, Time since) const;
};

/// Returns the names in `seen_by`. The robot that saw the landmark last comes first.
[[nodiscard]] std::vector<std::string> latest_first(const std::map<std::string, Time>& seen_by);

/// Returns whether two landmarks may be the same object: they have the same class, and no robot saw
/// both in one frame.
[[nodiscard]] bool may_be_same(const Landmark& a, const Landmark& b);

}  // namespace galilean::monitor
