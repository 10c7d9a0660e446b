// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/devices/frame_grabber.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// The devices of a robot over a serial line and a source of pictures. Live, an I/O thread for each
/// of the two pumps them; in a headless simulator they are pumped between ticks.
class RobotDevices final : public DeviceTuner {
 public:
  /// `settings` are those of the first program. Requires: line and source outlive this object.
  /// `tune` applies each later program's settings, except for the devices' names and the line's
  /// speed, in which the programs of one robot do not differ (see OpenedDevices). `tick_period` is
  /// that of the control loop.
  RobotDevices(ByteStream& line, FrameSource& camera, const DeviceSettings& settings,
               Duration tick_period = MicrocontrollerLink::kTickPeriod)
      : link_(line, settings.comm_port, tick_period),
        drive_(link_, settings.motor_drive),
        grabber_(camera, settings.frame_grabber) {}

  void pump_line(Time now) { link_.pump(now); }
  void pump_camera(Time now) { grabber_.pump(now); }
  /// Reports that the pump threw. The device counts as missing until the pump works again.
  void fail_line(const std::string& why) { link_.fail(why); }
  void fail_camera(const std::string& why) { grabber_.fail(why); }

  [[nodiscard]] Devices devices() noexcept { return {link_, drive_, grabber_}; }
  void tune(const DeviceSettings& settings) noexcept override {
    link_.set_timeout(from_seconds(settings.comm_port.timeout_s));
    drive_.configure(settings.motor_drive);
    grabber_.configure(settings.frame_grabber);
  }

 private:
  MicrocontrollerLink link_;
  WheelDrive drive_;
  CameraGrabber grabber_;
};

}  // namespace galilean::robot
