// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/landmark.h"

#include <algorithm>

namespace galilean::monitor {
namespace {

/// Returns the time [s] unseen in a visible area after which a landmark is removed. Missing trash
/// was carried away. Other objects stay, so they are more likely hidden.
double absence_noticed_s(const std::string& object_class) {
  return object_class == "trash" ? 1.5 : 6;
}

}  // namespace

void Landmark::observe(const std::string& robot, Time now) {
  decay(now);
  certainty = 1 - (1 - certainty) * kDoubtFactor;
  ++sightings;
  absent_s = 0;
  last_seen = seen_by[robot] = now;
}

void Landmark::decay(Time now) {
  certainty = std::max(0.0, certainty - to_seconds(now - decayed_until) / kMemory_s);
  decayed_until = now;
}

void Landmark::penalize(double for_s) {
  absent_s += for_s;
  certainty = std::max(0.0, certainty - for_s / absence_noticed_s(object_class));
}

bool Landmark::is_expired(Time now) const noexcept {
  const bool retained =
      is_confirmed() && object_class != "obstacle" && to_seconds(now - last_seen) < kRetention_s;
  return absent_s > absence_noticed_s(object_class) || (certainty <= 0 && !retained);
}

void Landmark::merge(const Landmark& other) {
  certainty = std::max(certainty, other.certainty);
  sightings += other.sightings;
  first_seen = std::min(first_seen, other.first_seen);
  last_seen = std::max(last_seen, other.last_seen);
  absent_s = std::min(absent_s, other.absent_s);
  for (const auto& [robot, at] : other.seen_by) seen_by[robot] = std::max(seen_by[robot], at);
}

bool Landmark::was_seen_by(const std::string& robot, Time since) const {
  const auto seen = seen_by.find(robot);
  return seen != seen_by.end() && seen->second > since;
}

bool may_be_same(const Landmark& a, const Landmark& b) {
  if (a.id == b.id || a.object_class != b.object_class || a.object_class == "obstacle")
    return false;
  return std::ranges::none_of(a.seen_by, [&](const auto& seen) {
    const auto other = b.seen_by.find(seen.first);
    return other != b.seen_by.end() && other->second == seen.second;
  });
}

std::vector<std::string> latest_first(const std::map<std::string, Time>& seen_by) {
  std::vector<std::string> names;
  for (const auto& [robot, at] : seen_by) names.push_back(robot);
  std::ranges::stable_sort(
      names, [&](const auto& a, const auto& b) { return seen_by.at(a) > seen_by.at(b); });
  return names;
}

}  // namespace galilean::monitor
