#pragma once

#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/estimation/robot_poses.h"

namespace galilean::monitor {

/// One robot saw a robot: corrects both, where it is clear which one it was. Cameras do not tell
/// robots apart; the one that is meant must be heard of lately, inside the gate, and alone there.
/// `others`: robots that are not of the joint distribution, and may have been meant.
void note_meetings(const msg::Sightings& frame, const RobotPoses& robots, JointGaussian& joint,
                   const std::vector<Gaussian2>& others, Time now);

}  // namespace galilean::monitor
