#pragma once

#include "core/wire/messages.h"
#include "monitor/map/robot_poses.h"

namespace galilean::monitor {

/// One robot saw a robot: corrects both, where it is clear which one it was. Cameras do not tell
/// robots apart; the one that is meant must be heard of lately, inside the gate, and alone there.
void note_meetings(const msg::Sightings& frame, const RobotPoses& robots, JointGaussian& joint,
                   Time now);

}  // namespace galilean::monitor
