// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/landmark_publication.h"

#include <Eigen/LU>
#include <algorithm>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kPublishedDuplicate_m = 0.25;  ///< duplicates of one object are no further apart
/// Standard deviation of the error between two estimates of one object that no covariance contains.
constexpr double kPublishedUnmodelled_m = 0.05;
/// A position is not published above this standard deviation. An object that was only seen from far
/// away may stand anywhere within metres.
constexpr double kMaxPublishedDeviation_m = 0.75;

}  // namespace

bool is_duplicate_candidate(const JointGaussian& joint, const LandmarkStore& landmarks,
                            const Landmark& landmark) {
  const Gaussian2 at = landmarks.position(landmark);
  return std::ranges::any_of(landmarks.all(), [&](const Landmark& other) {
    const Vec2 apart = at.mean_m - joint.position(other.block);
    if (apart.norm() > kPublishedDuplicate_m || !other.is_publishable() ||
        !may_be_same(landmark, other))
      return false;
    if (joint.covariance(other.block).trace() >= at.covariance_m2.trace()) return false;
    const JointGaussian::Term difference[] = {{other.block, Mat2::Identity()},
                                              {landmark.block, -Mat2::Identity()}};
    const Mat2 covariance = joint.covariance(difference) +
                            kPublishedUnmodelled_m * kPublishedUnmodelled_m * Mat2::Identity();
    return apart.dot(covariance.inverse() * apart) < association_gate();
  });
}

bool is_published(const JointGaussian& joint, const LandmarkStore& landmarks,
                  const Landmark& landmark) {
  return landmark.is_publishable() &&
         joint.covariance(landmark.block).trace() <=
             kMaxPublishedDeviation_m * kMaxPublishedDeviation_m &&
         !is_duplicate_candidate(joint, landmarks, landmark);
}

}  // namespace galilean::monitor
