#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// Where something is on the floor, as a normal distribution.
struct Gaussian2 {
  Vec2 mean_m = Vec2::Zero();
  Mat2 covariance_m2 = Mat2::Identity();
};

/// Both say where the same thing is: what follows from them together
/// (mrpt::poses::CPointPDFGaussian).
[[nodiscard]] Gaussian2 fused(const Gaussian2& a, const Gaussian2& b);

/// (a - b)ᵀ (A + B)⁻¹ (a - b): how far apart two estimates are, in the measure of what they do not
/// know. Of the same thing it is below `same_thing_gate()` with a probability of 99 %.
[[nodiscard]] double squared_mahalanobis(const Gaussian2& a, const Gaussian2& b);
[[nodiscard]] double same_thing_gate();
/// chi²'s inverse for the three degrees of freedom of a pose, at 99.9 %.
[[nodiscard]] double same_pose_gate();

}  // namespace galilean::monitor
