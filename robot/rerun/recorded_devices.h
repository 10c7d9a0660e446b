// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/camera_geometry.h"
#include "core/device/comm_port.h"
#include "core/device/devices.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"
#include "robot/executive/device_settings.h"

namespace galilean::robot {

// Devices that give what they are given. What they are ordered has no effect.

class RecordedPort final : public CommPort {
 public:
  void give(const ControllerStatus& status, bool healthy) noexcept {
    status_ = status;
    healthy_ = healthy;
  }
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return healthy_; }
  [[nodiscard]] std::string problem() const override { return {}; }
  [[nodiscard]] const ControllerStatus& status() const noexcept override { return status_; }
  void command_gripper(GripperCommand) noexcept override {}

 private:
  ControllerStatus status_;
  bool healthy_ = false;
};

class RecordedDrive final : public MotorDrive {
 public:
  void give(bool healthy) noexcept { healthy_ = healthy; }
  void configure(const MotorDriveSettings& settings) noexcept { settings_ = settings.motion(); }
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return healthy_; }
  [[nodiscard]] std::string problem() const override { return {}; }
  void drive(const DriveCommand&) noexcept override {}
  void stop() noexcept override {}
  [[nodiscard]] double forward_speed_mps() const noexcept override {
    return settings_.forward_speed_mps;
  }
  [[nodiscard]] double turning_speed_radps() const noexcept override {
    return settings_.turning_speed_radps;
  }
  [[nodiscard]] double turn_radius_m() const noexcept override { return settings_.turn_radius_m; }

 private:
  MotorDriveSettings::Motion settings_ = MotorDriveSettings().motion();
  bool healthy_ = false;
};

class RecordedCamera final : public FrameGrabber {
 public:
  /// Returns the newest picture, to be changed between ticks.
  [[nodiscard]] Frame& picture() noexcept { return frame_; }
  void give(bool healthy) noexcept { healthy_ = healthy; }
  void configure(const FrameGrabberSettings& settings) noexcept { geometry_ = settings.geometry(); }
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return healthy_; }
  [[nodiscard]] std::string problem() const override { return {}; }
  [[nodiscard]] const Frame& frame() const noexcept override { return frame_; }
  [[nodiscard]] const CameraGeometry& geometry() const noexcept override { return geometry_; }

 private:
  Frame frame_;
  CameraGeometry geometry_ = FrameGrabberSettings().geometry();
  bool healthy_ = false;
};

/// The devices of a robot that runs again. Like real ones they take over each program's settings.
class RecordedDevices final : public DeviceTuner {
 public:
  void tune(const DeviceSettings& settings) noexcept override {
    drive.configure(settings.motor_drive);
    camera.configure(settings.frame_grabber);
  }
  [[nodiscard]] Devices devices() noexcept { return {port, drive, camera}; }

  RecordedPort port;
  RecordedDrive drive;
  RecordedCamera camera;
};

}  // namespace galilean::robot
