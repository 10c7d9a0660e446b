#pragma once

#include <vector>

#include "monitor/map/estimation/joint_gaussian.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Lays robots and landmarks as `fit` says, all together: what they know of one another stays. How
/// far off the fit may be is an unknown that they share.
void transport(JointGaussian& joint, const std::vector<JointGaussian::Part>& parts,
               const RigidFit& fit);

/// The fit would not move a robot there by more than landmarks differ anyway.
[[nodiscard]] bool is_there_already(const Vec2& robot_m, const RigidFit& fit);

/// The same transformation, up to what fits of a few landmarks differ by.
[[nodiscard]] bool are_near(const RigidFit& a, const RigidFit& b);

}  // namespace galilean::monitor
