// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monitor/map/estimation/joint_gaussian.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Transforms robots and landmarks as `fit` says, all together, so that the errors which they share
/// are kept. The error of the fit itself is added as one unknown that all of them share.
void transform_blocks(JointGaussian& joint, const std::vector<JointGaussian::Block>& blocks,
                      const RigidFit& fit);

/// Returns whether the fit would move a robot at `robot_m` (map frame) by no more than fits differ
/// anyway.
[[nodiscard]] bool is_negligible(const Vec2& robot_m, const RigidFit& fit);

/// Returns whether two fits are the same transformation, up to the errors of fits to a few points.
[[nodiscard]] bool are_similar(const RigidFit& a, const RigidFit& b);

}  // namespace galilean::monitor
