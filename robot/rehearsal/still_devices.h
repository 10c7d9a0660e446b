// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/camera_geometry.h"
#include "core/device/comm_port.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {

/// Devices that are healthy and perceive nothing: no bumper is touched, the picture stays black,
/// and the robot stands still whatever is commanded.
class StillPort final : public CommPort {
 public:
  void sense(Time now) noexcept override { status_.received = now; }
  [[nodiscard]] bool healthy() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override { return {}; }
  [[nodiscard]] const ControllerStatus& status() const noexcept override { return status_; }
  void command_gripper(GripperCommand) noexcept override {}

 private:
  ControllerStatus status_;
};

class StillDrive final : public MotorDrive {
 public:
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override { return {}; }
  void drive(const DriveCommand&) noexcept override {}
  void stop() noexcept override {}
  [[nodiscard]] double forward_speed_mps() const noexcept override { return 0.3; }
  [[nodiscard]] double turning_speed_radps() const noexcept override { return 1; }
  [[nodiscard]] double turn_radius_m() const noexcept override { return 0.2; }
};

class StillCamera final : public FrameGrabber {
 public:
  void sense(Time now) noexcept override { frame_.captured = now; }
  [[nodiscard]] bool healthy() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override { return {}; }
  [[nodiscard]] const Frame& frame() const noexcept override { return frame_; }
  [[nodiscard]] const CameraGeometry& geometry() const noexcept override { return geometry_; }

 private:
  Frame frame_;
  CameraGeometry geometry_;
};

}  // namespace galilean::robot
