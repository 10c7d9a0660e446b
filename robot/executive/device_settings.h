// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/program/program.h"
#include "robot/devices/comm_port_settings.h"
#include "robot/devices/frame_grabber_settings.h"
#include "robot/devices/motor_drive_settings.h"

namespace galilean::robot {

/// What a program says of the robot's devices; the defaults of the catalog where it says nothing.
struct DeviceSettings {
  CommPortSettings comm_port;
  MotorDriveSettings motor_drive;
  FrameGrabberSettings frame_grabber;
  bool uses_camera = false;  ///< it names a frame_grabber

  [[nodiscard]] static DeviceSettings of(const bhdl::Program& program);
};

/// Takes a program's settings over when that program does. Belongs to the control loop: it neither
/// allocates nor waits.
class DeviceTuner {
 public:
  virtual ~DeviceTuner() = default;
  virtual void tune(const DeviceSettings& settings) noexcept = 0;
};

}  // namespace galilean::robot
