#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/map/estimation/joint_gaussian.h"

namespace galilean::monitor {

/// Something that stands on the floor, as the team remembers it. Its place is a part of the joint
/// distribution.
///
///   law     certainty c becomes 1 - (1 - c) · kDoubtFactor with each sighting and falls by 1 in
///           kMemory. At 0 it is told no more, but kept for kRetention as something to find one's
///           way by. It is forgotten when somebody had its place in plain view for long enough and
///           saw nothing. What was seen less than kConfirmingSightings times may be a trick of the
///           light: it is not told, nor kept.
///   source  the paper's minute of memory; the rest is ours
struct Landmark {
  static constexpr double kMemory_s = 60;
  static constexpr double kRetention_s = 900;
  static constexpr double kDoubtFactor = 0.6;
  static constexpr unsigned kConfirmingSightings = 3;
  static constexpr Duration kRecent = std::chrono::seconds(12);
  /// A robot that lost its way sees anew what it knew before.
  static constexpr Duration kObservationWindow = std::chrono::seconds(10);

  std::uint64_t id = 0;  ///< the same as long as it is remembered
  std::string object_class;
  JointGaussian::Part part = 0;
  Time first_seen{};
  Time last_seen{};
  Time decayed{};  ///< until when the decay is reckoned in
  double certainty = 0;
  unsigned sightings = 0;
  double absent_s = 0;                  ///< its place was in plain view for so long, and empty
  std::map<std::string, Time> seen_by;  ///< robots, and when each saw it last

  void observe(const std::string& robot, Time now);
  void decay(Time now);
  /// Its place was in plain view for so long, and empty.
  void penalize(double for_s);
  /// It is the same as `other`, which was noted twice.
  void merge(const Landmark& other);

  [[nodiscard]] bool is_expired(Time now) const noexcept;
  [[nodiscard]] bool is_confirmed() const noexcept {
    return sightings >= kConfirmingSightings || object_class == "obstacle";
  }
  [[nodiscard]] bool is_publishable() const noexcept { return is_confirmed() && certainty > 0; }
  /// Only this robot saw it, and not for long: it may be something older, seen by one that is not
  /// where it is believed to be.
  [[nodiscard]] bool is_recent_of(const std::string& robot, Time now) const {
    return now - first_seen < kRecent && seen_by.size() == 1 && was_seen_by(robot);
  }
  [[nodiscard]] bool was_seen_by(const std::string& robot) const { return seen_by.contains(robot); }
  [[nodiscard]] bool was_seen_by(const std::string& robot, Time since) const;
};

/// Who saw it, the latest first.
[[nodiscard]] std::vector<std::string> latest_first(const std::map<std::string, Time>& seen_by);

/// Of one class, and no robot saw them as two in the frame that it saw either in last.
[[nodiscard]] bool may_be_same(const Landmark& a, const Landmark& b);

}  // namespace galilean::monitor
