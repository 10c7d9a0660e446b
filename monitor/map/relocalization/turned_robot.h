#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// What a robot saw, or what is known: where, and of which kind.
struct Mark {
  Vec2 in_map_m;
  std::size_t kind = 0;
  std::uint64_t id = 0;
};

[[nodiscard]] std::size_t mark_kind(const std::string& object_class);

/// A robot that was wedged, or pushed, faces otherwise than it is believed to, and what it sees
/// lies beside what is known by one and the same turn about it and one shift.
///
///   law     every two of `seen` are laid on every two of `known` of their kinds that are as far
///           apart; the turn and shift that most of `seen` agree on counts where at least
///           kLeastAgreeing do, most of all that was seen, and no other turn does nearly as well
///   units   turns up to kMostTurn_rad, shifts of the robot up to kMostShift_m, or what it is told
struct TurnedRobot {
  static constexpr std::size_t kLeastAgreeing = 4;
  static constexpr double kMostTurn_rad = 1.4;
  static constexpr double kMostShift_m = 1.2;

  /// From where landmarks were noted to where they are; `agreeing` says which. Nothing if it is not
  /// clear.
  [[nodiscard]] static std::optional<RigidFit> fit(const std::vector<Mark>& seen,
                                                   const std::vector<Mark>& known,
                                                   const Vec2& robot_m,
                                                   double most_shift_m = kMostShift_m);
};

}  // namespace galilean::monitor
