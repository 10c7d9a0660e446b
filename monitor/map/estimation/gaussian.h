#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// Where something is on the floor, as a normal distribution.
struct Gaussian2 {
  Vec2 mean_m = Vec2::Zero();
  Mat2 covariance_m2 = Mat2::Identity();
};

/// Turns vectors counter-clockwise by so much.
[[nodiscard]] Mat2 rotation_by(double angle_rad);

/// (a - b)ᵀ (A + B)⁻¹ (a - b): how far apart two estimates are, in the measure of what they do not
/// know. Of the same landmark it is below `same_thing_gate()` with a probability of 99 %.
[[nodiscard]] double squared_mahalanobis(const Gaussian2& a, const Gaussian2& b);
[[nodiscard]] double same_thing_gate();

}  // namespace galilean::monitor
