// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

class CommPort;
class MotorDrive;
class FrameGrabber;

/// What a robot has. Outlives every program that it runs.
struct Devices {
  CommPort& comm_port;
  MotorDrive& motor_drive;
  FrameGrabber& frame_grabber;
};

}  // namespace galilean
