// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/program/program.h"
#include "core/catalog/catalog.h"
#include "robot/devices/comm_port_settings.h"
#include "robot/devices/frame_grabber_settings.h"
#include "robot/devices/motor_drive_settings.h"

namespace galilean::robot {

/// A program's settings for the robot's devices. Where the program has none, these are the defaults
/// of the catalog.
struct DeviceSettings {
  CommPortSettings comm_port;
  MotorDriveSettings motor_drive;
  FrameGrabberSettings frame_grabber;
  bool uses_camera = false;  ///< a state lists a schema that needs the frame_grabber, whether or
                             ///< not the program names one

  /// Requires: the program was checked against `catalog`.
  [[nodiscard]] static DeviceSettings of(const bhdl::Program& program, const Catalog& catalog);
};

/// Applies a program's device settings when that program takes over. The control loop calls it. It
/// neither allocates nor waits.
class DeviceTuner {
 public:
  virtual ~DeviceTuner() = default;
  virtual void tune(const DeviceSettings& settings) noexcept = 0;
};

}  // namespace galilean::robot
