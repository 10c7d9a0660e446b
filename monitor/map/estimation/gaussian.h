// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// A position on the floor as a normal distribution. The frame is said where one is used.
struct Gaussian2 {
  Vec2 mean_m = Vec2::Zero();
  Mat2 covariance_m2 = Mat2::Identity();
};

/// Returns the matrix that turns vectors counter-clockwise by `angle_rad`.
[[nodiscard]] Mat2 rotation_matrix(double angle_rad);

/// Returns (a - b)ᵀ (A + B)⁻¹ (a - b), the squared Mahalanobis distance between two independent
/// estimates. It has no unit.
[[nodiscard]] double squared_mahalanobis(const Gaussian2& a, const Gaussian2& b);

/// Returns the gate of data association: the 99 % quantile of chi² with two degrees of freedom. The
/// squared Mahalanobis distance of two estimates of one position is below it in 99 of 100 cases.
[[nodiscard]] double association_gate();

}  // namespace galilean::monitor
