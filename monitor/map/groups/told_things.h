#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/map/groups/squads.h"

namespace galilean::monitor {

/// A landmark as the team tells it: what one squad noted of it, or several.
struct ToldThing {
  struct Note {
    Squad* squad;
    std::uint64_t id;  ///< in its landmarks
  };

  std::uint64_t id = 0;  ///< the lowest of its notes
  std::string object_class;
  Gaussian2 place;
  double certainty = 0;
  Time last_seen{};
  std::map<std::string, Time> seen_by;  ///< robots, and when each saw it last
  std::vector<Note> notes;              ///< one a squad at most

  [[nodiscard]] bool has(const Squad& squad, std::uint64_t landmark) const;
};

/// Two squads' notes that may be of one landmark.
struct SamePair {
  std::size_t a, b;
  double squared_distance;
  bool is_sure;  ///< nothing else comes into question
};
/// Of one class, near one another and inside the gate, of squads that were placed; the nearest
/// first.
[[nodiscard]] std::vector<SamePair> same_pairs(const std::vector<ToldThing>& notes);

/// What other squads noted that were placed, and this one perhaps as well.
[[nodiscard]] std::vector<Mark> known_to_others(const Squad& squad,
                                                const std::vector<ToldThing>& told);

/// What each squad would tell by itself.
[[nodiscard]] std::vector<ToldThing> squads_notes(const Squads& squads);
/// Notes that are of one landmark become one, the nearest first, no two of a squad: they saw those
/// as two. It stands where it is known best; what they learnt of one another is not counted twice.
[[nodiscard]] std::vector<ToldThing> united(std::vector<ToldThing> notes,
                                            const std::vector<SamePair>& pairs);

}  // namespace galilean::monitor
