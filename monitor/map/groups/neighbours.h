#pragma once

#include <map>
#include <vector>

#include "monitor/map/groups/told_things.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// What squads learn from one another, of which none knows what errors they have in common.
///
///   law     where one knows the place of a landmark far better than another, that one believes it,
///   up
///           to an error that cannot be told away. A squad that nobody placed is laid where most of
///           what it saw agrees with what the others know (fit_rigidly), if it is so twice running.
class Neighbours {
 public:
  static constexpr std::size_t kLeastAgreeing = 8;

  explicit Neighbours(Squads& squads) : squads_(squads) {}

  /// `pairs` are among `notes`.
  static void teach(const std::vector<ToldThing>& notes, const std::vector<SamePair>& pairs);
  /// Of one squad, another one with each call.
  void find_unplaced(const std::vector<ToldThing>& told);

 private:
  void find(Squad& squad, const std::vector<ToldThing>& told);

  Squads& squads_;
  std::size_t next_ = 0;
  std::map<const Squad*, RigidFit> candidates_;  ///< found once
};

}  // namespace galilean::monitor
