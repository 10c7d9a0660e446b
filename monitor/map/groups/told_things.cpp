#include "monitor/map/groups/told_things.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace galilean::monitor {
namespace {

constexpr double kWithin_m = 0.30;      ///< notes of one landmark lie nearer to one another
constexpr double kNotesApart_m = 0.05;  ///< by which either may err unbeknown
/// Another pair that fits nearly as well, by squared Mahalanobis distance.
constexpr double kNotesRivalMargin = 6;

ToldThing told(Squad& squad, const Landmark& landmark) {
  return {landmark.id,
          landmark.object_class,
          squad.landmarks.place(landmark),
          landmark.certainty,
          landmark.last_seen,
          landmark.seen_by,
          {{&squad, landmark.id}}};
}

double squared_distance(const ToldThing& a, const ToldThing& b) {
  Gaussian2 unsure = b.place;
  unsure.covariance_m2 += kNotesApart_m * kNotesApart_m * Mat2::Identity();
  return squared_mahalanobis(a.place, unsure);
}

/// By place, from left to right.
std::vector<std::size_t> swept(const std::vector<ToldThing>& notes) {
  std::vector<std::size_t> order(notes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return notes[i].place.mean_m.x(); });
  return order;
}

void mark_rivals(std::vector<SamePair>& pairs) {
  const auto shares = [](const SamePair& a, const SamePair& b) {
    return a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b;
  };
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < pairs.size() && pairs[i].is_sure; ++j)
      pairs[i].is_sure = i == j || !shares(pairs[i], pairs[j]) ||
                         pairs[j].squared_distance > pairs[i].squared_distance + kNotesRivalMargin;
}

bool is_placed(const ToldThing& note) {
  return note.notes.front().squad->placed;
}

bool share_a_squad(const ToldThing& a, const ToldThing& b) {
  return std::ranges::any_of(a.notes, [&](const auto& note) {
    return std::ranges::any_of(b.notes,
                               [&](const auto& other) { return other.squad == note.squad; });
  });
}

void absorb(ToldThing& landmark, const ToldThing& other) {
  landmark.id = std::min(landmark.id, other.id);
  if (other.place.covariance_m2.trace() < landmark.place.covariance_m2.trace())
    landmark.place = other.place;
  landmark.certainty = std::max(landmark.certainty, other.certainty);
  landmark.last_seen = std::max(landmark.last_seen, other.last_seen);
  landmark.seen_by.insert(other.seen_by.begin(), other.seen_by.end());
  landmark.notes.insert(landmark.notes.end(), other.notes.begin(), other.notes.end());
}

}  // namespace

bool ToldThing::has(const Squad& squad, std::uint64_t landmark) const {
  return std::ranges::any_of(
      notes, [&](const Note& note) { return note.squad == &squad && note.id == landmark; });
}

std::vector<Mark> known_to_others(const Squad& squad, const std::vector<ToldThing>& told) {
  std::vector<Mark> known;
  for (const auto& landmark : told) {
    const bool others = std::ranges::any_of(landmark.notes, [&](const ToldThing::Note& note) {
      return note.squad != &squad && note.squad->placed;
    });
    if (others && landmark.object_class != "obstacle")
      known.push_back({landmark.place.mean_m, mark_kind(landmark.object_class), landmark.id});
  }
  return known;
}

std::vector<ToldThing> squads_notes(const Squads& squads) {
  std::vector<ToldThing> notes;
  for (const auto& squad : squads.all())
    for (const auto& landmark : squad->landmarks.all())
      if (squad->landmarks.is_published(landmark)) notes.push_back(told(*squad, landmark));
  return notes;
}

std::vector<SamePair> same_pairs(const std::vector<ToldThing>& notes) {
  std::vector<SamePair> pairs;
  const auto order = swept(notes);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const ToldThing &a = notes[order[i]], &b = notes[order[j]];
      const Vec2 apart = b.place.mean_m - a.place.mean_m;
      if (apart.x() > kWithin_m) break;
      if (apart.norm() > kWithin_m || a.object_class != b.object_class || share_a_squad(a, b) ||
          !is_placed(a) || !is_placed(b))
        continue;
      const double distance = squared_distance(a, b);
      if (distance < same_thing_gate()) pairs.push_back({order[i], order[j], distance, true});
    }
  std::ranges::stable_sort(pairs, {}, &SamePair::squared_distance);
  mark_rivals(pairs);
  return pairs;
}

std::vector<ToldThing> united(std::vector<ToldThing> notes, const std::vector<SamePair>& pairs) {
  std::vector<std::size_t> into(notes.size());
  std::iota(into.begin(), into.end(), 0);
  const auto root = [&](std::size_t i) {
    while (into[i] != i) i = into[i];
    return i;
  };
  for (const auto& pair : pairs) {
    const std::size_t a = root(pair.a), b = root(pair.b);
    if (a == b || share_a_squad(notes[a], notes[b])) continue;
    absorb(notes[a], notes[b]);
    into[b] = a;
  }
  std::vector<ToldThing> result;
  for (std::size_t i = 0; i < notes.size(); ++i)
    if (into[i] == i) result.push_back(std::move(notes[i]));
  return result;
}

}  // namespace galilean::monitor
