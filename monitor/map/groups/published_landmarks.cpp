// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/groups/published_landmarks.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace galilean::monitor {
namespace {

constexpr double kUnionDuplicate_m = 0.30;  ///< estimates of one object are no further apart
/// Standard deviation of the error between two groups' estimates that no covariance contains.
constexpr double kUnmodelled_m = 0.05;
/// A pair has a rival if another pair's squared Mahalanobis distance is larger by less than this.
constexpr double kUnionRivalMargin = 6;

PublishedLandmark published(RobotGroup& group, const Landmark& landmark) {
  return {landmark.id,
          landmark.object_class,
          group.landmarks.position(landmark),
          landmark.certainty,
          landmark.last_seen,
          landmark.seen_by,
          {{&group, landmark.id}}};
}

double squared_distance(const PublishedLandmark& a, const PublishedLandmark& b) {
  Gaussian2 inflated = b.position;
  inflated.covariance_m2 += kUnmodelled_m * kUnmodelled_m * Mat2::Identity();
  return squared_mahalanobis(a.position, inflated);
}

/// Returns the indices in the order of x, so that neighbours are found by a sweep from left to
/// right.
std::vector<std::size_t> in_order_of_x(const PublishedLandmarks& landmarks) {
  std::vector<std::size_t> order(landmarks.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return landmarks[i].position.mean_m.x(); });
  return order;
}

void mark_rivals(std::vector<DuplicatePair>& pairs) {
  const auto shares = [](const DuplicatePair& a, const DuplicatePair& b) {
    return a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b;
  };
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < pairs.size() && pairs[i].is_sure; ++j)
      pairs[i].is_sure = i == j || !shares(pairs[i], pairs[j]) ||
                         pairs[j].squared_distance > pairs[i].squared_distance + kUnionRivalMargin;
}

bool is_localized(const PublishedLandmark& landmark) {
  return landmark.sources.front().group->is_localized;
}

bool share_a_group(const PublishedLandmark& a, const PublishedLandmark& b) {
  return std::ranges::any_of(a.sources, [&](const auto& source) {
    return std::ranges::any_of(b.sources,
                               [&](const auto& other) { return other.group == source.group; });
  });
}

void merge(PublishedLandmark& landmark, const PublishedLandmark& other) {
  landmark.id = std::min(landmark.id, other.id);
  if (other.position.covariance_m2.trace() < landmark.position.covariance_m2.trace())
    landmark.position = other.position;
  landmark.certainty = std::max(landmark.certainty, other.certainty);
  landmark.last_seen = std::max(landmark.last_seen, other.last_seen);
  landmark.seen_by.insert(other.seen_by.begin(), other.seen_by.end());
  landmark.sources.insert(landmark.sources.end(), other.sources.begin(), other.sources.end());
}

}  // namespace

bool PublishedLandmark::has(const RobotGroup& group, std::uint64_t landmark) const {
  return std::ranges::any_of(sources, [&](const Source& source) {
    return source.group == &group && source.id == landmark;
  });
}

PublishedLandmarks landmarks_by_group(const RobotGroups& groups) {
  PublishedLandmarks landmarks;
  for (const auto& group : groups.all())
    for (const auto& landmark : group->landmarks.all())
      if (group->landmarks.is_published(landmark)) landmarks.push_back(published(*group, landmark));
  return landmarks;
}

std::vector<DuplicatePair> duplicate_pairs(const PublishedLandmarks& landmarks) {
  std::vector<DuplicatePair> pairs;
  const auto order = in_order_of_x(landmarks);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const PublishedLandmark &a = landmarks[order[i]], &b = landmarks[order[j]];
      const Vec2 apart = b.position.mean_m - a.position.mean_m;
      if (apart.x() > kUnionDuplicate_m) break;
      if (apart.norm() > kUnionDuplicate_m || a.object_class != b.object_class ||
          share_a_group(a, b) || !is_localized(a) || !is_localized(b))
        continue;
      const double distance = squared_distance(a, b);
      if (distance < association_gate()) pairs.push_back({order[i], order[j], distance, true});
    }
  std::ranges::stable_sort(pairs, {}, &DuplicatePair::squared_distance);
  mark_rivals(pairs);
  return pairs;
}

PublishedLandmarks merged(PublishedLandmarks landmarks, const std::vector<DuplicatePair>& pairs) {
  std::vector<std::size_t> into(landmarks.size());
  std::iota(into.begin(), into.end(), 0);
  const auto root = [&](std::size_t i) {
    while (into[i] != i) i = into[i];
    return i;
  };
  for (const auto& pair : pairs) {
    const std::size_t a = root(pair.a), b = root(pair.b);
    if (a == b || share_a_group(landmarks[a], landmarks[b])) continue;
    merge(landmarks[a], landmarks[b]);
    into[b] = a;
  }
  PublishedLandmarks result;
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    if (into[i] == i) result.push_back(std::move(landmarks[i]));
  return result;
}

std::vector<LabelledPoint> known_to_others(const RobotGroup& group,
                                           const PublishedLandmarks& published) {
  std::vector<LabelledPoint> known;
  for (const auto& landmark : published) {
    const bool others = std::ranges::any_of(landmark.sources, [&](const auto& source) {
      return source.group != &group && source.group->is_localized;
    });
    if (others && landmark.object_class != "obstacle")
      known.push_back({landmark.position.mean_m, label_of(landmark.object_class), landmark.id});
  }
  return known;
}

}  // namespace galilean::monitor
