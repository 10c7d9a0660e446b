// SPDX-License-Identifier: BSD-3-Clause
#include "robot/components.h"

#include "robot/devices/comm_port_settings.h"
#include "robot/devices/frame_grabber_settings.h"
#include "robot/devices/motor_drive_settings.h"
#include "robot/motor/avoid_obstacle.h"
#include "robot/motor/avoid_robot.h"
#include "robot/motor/combine_forces.h"
#include "robot/motor/dock.h"
#include "robot/motor/guarded_goal.h"
#include "robot/motor/move_gripper.h"
#include "robot/motor/move_robot.h"
#include "robot/motor/move_to_goal.h"
#include "robot/motor/noise.h"
#include "robot/motor/probe.h"
#include "robot/motor/swirl.h"
#include "robot/perceptual/arrived.h"
#include "robot/perceptual/blob_detector.h"
#include "robot/perceptual/bumper_scanner.h"
#include "robot/perceptual/forget.h"
#include "robot/perceptual/gripper_scanner.h"
#include "robot/perceptual/look.h"
#include "robot/perceptual/lost.h"
#include "robot/perceptual/obstacle_detector.h"
#include "robot/perceptual/seen.h"
#include "robot/perceptual/stuck_detector.h"
#include "robot/perceptual/time_detector.h"
#include "robot/variables/settings.h"

namespace galilean::robot {

void add_components(Registry& registry) {
  registry.add_settings<CommPortSettings>("comm_port", ComponentKind::kInputDevice);
  registry.add_settings<CommPortSettings>("communication_port", ComponentKind::kInputDevice);
  registry.add_settings<FrameGrabberSettings>("frame_grabber", ComponentKind::kInputDevice);
  registry.add_settings<MotorDriveSettings>("motor_drive", ComponentKind::kOutputDevice);

  registry.add_settings<ShaftSettings>("shaft", ComponentKind::kVariable);
  registry.add_settings<ImageSettings>("image", ComponentKind::kVariable);
  registry.add_settings<LocateSettings>("locate", ComponentKind::kVariable);
  registry.add_settings<BitsSettings>("bits", ComponentKind::kVariable);
  registry.add_settings<ForceSettings>("force", ComponentKind::kVariable);

  registry.add_schema<BumperScanner>("bumper_scanner");
  registry.add_schema<GripperScanner>("gripper_scanner");
  registry.add_schema<ObstacleDetector>("obstacle_detector");
  registry.add_schema<Look>("look");
  registry.add_schema<BlobDetector>("blob_detector");
  registry.add_schema<TimeDetector>("time_detector");
  registry.add_schema<Forget>("forget");
  registry.add_schema<Seen>("seen");
  registry.add_schema<Lost>("lost");
  registry.add_schema<StuckDetector>("stuck_detector");
  registry.add_schema<Arrived>("arrived");

  registry.add_schema<AvoidObstacle>("avoid_obstacle");
  registry.add_schema<AvoidRobot>("avoid_robot");
  registry.add_schema<Swirl>("swirl");
  registry.add_schema<Noise>("noise");
  registry.add_schema<MoveToGoal>("move_to_goal");
  registry.add_schema<GuardedGoal>("guarded_goal");
  registry.add_schema<Probe>("probe");
  registry.add_schema<Dock>("dock");
  registry.add_schema<CombineForces>("combine_forces");
  registry.add_schema<MoveRobot>("move_robot");
  registry.add_schema<MoveGripper>("move_gripper");
}

}  // namespace galilean::robot
