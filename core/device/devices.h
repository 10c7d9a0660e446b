// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

class CommPort;
class MotorDrive;
class FrameGrabber;

/// The devices of a robot. They outlive every program that the robot runs.
struct Devices {
  CommPort& comm_port;
  MotorDrive& motor_drive;
  FrameGrabber& frame_grabber;
};

}  // namespace galilean
