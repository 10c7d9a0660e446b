// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/groups/share_landmarks.h"

#include <algorithm>

namespace galilean::monitor {
namespace {

/// A group takes over a position if its own estimate has more than so many times the variance.
constexpr double kFarBetter = 2;
/// Standard deviation that is added to another group's estimate. Without it, two groups that share
/// one position would become more certain of it with each exchange.
constexpr double kSharedEstimateNoise_m = 0.05;
/// Above this squared Mahalanobis distance between two groups' estimates of a piece of trash, it
/// was more likely pushed since then.
constexpr double kSharedMovedDistance = 4;

void teach(const PublishedLandmark& known, const PublishedLandmark& learned) {
  const Mat2 shared = known.position.covariance_m2 +
                      kSharedEstimateNoise_m * kSharedEstimateNoise_m * Mat2::Identity();
  if (learned.position.covariance_m2.trace() < kFarBetter * shared.trace()) return;
  const auto& [group, id] = learned.sources.front();
  const auto landmark = std::ranges::find(group->landmarks.all(), id, &Landmark::id);
  const JointGaussian::Term itself[] = {{landmark->block, Mat2::Identity()}};
  const Vec2 innovation = known.position.mean_m - group->joint.position(landmark->block);
  group->joint.correct(itself, innovation, shared);
}

}  // namespace

void share_landmarks(const PublishedLandmarks& landmarks, const std::vector<DuplicatePair>& pairs) {
  for (const auto& pair : pairs) {
    const PublishedLandmark &a = landmarks[pair.a], &b = landmarks[pair.b];
    const bool may_have_moved =
        a.object_class == "trash" && pair.squared_distance > kSharedMovedDistance;
    if (!pair.is_sure || may_have_moved || a.object_class == "obstacle") continue;
    const bool a_knows = a.position.covariance_m2.trace() < b.position.covariance_m2.trace();
    teach(a_knows ? a : b, a_knows ? b : a);
  }
}

}  // namespace galilean::monitor
