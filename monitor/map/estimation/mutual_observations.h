// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/estimation/robot_poses.h"

namespace galilean::monitor {

/// Corrects two robots by one seeing the other. Cameras do not tell robots apart, so that a
/// sighting counts only if one robot can be meant: it was heard of lately, it is inside the gate,
/// and no other is near it. `others` are the positions, in the map frame, of robots that are not in
/// this joint distribution and may have been meant.
void correct_by_mutual_observations(const msg::Sightings& frame, const RobotPoses& robots,
                                    JointGaussian& joint, const std::vector<Gaussian2>& others,
                                    Time now);

}  // namespace galilean::monitor
