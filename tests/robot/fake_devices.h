// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/device/camera_geometry.h"
#include "core/device/comm_port.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {

struct FakeCommPort final : CommPort {
  ControllerStatus state;
  bool up = true;
  std::vector<GripperCommand> commands;

  void sense(Time) noexcept override {}
  bool healthy() const noexcept override { return up; }
  std::string problem() const override { return {}; }
  const ControllerStatus& status() const noexcept override { return state; }
  void command_gripper(GripperCommand command) noexcept override { commands.push_back(command); }
};

struct FakeMotorDrive final : MotorDrive {
  DriveCommand last;
  int commands = 0;

  void sense(Time) noexcept override {}
  bool healthy() const noexcept override { return true; }
  std::string problem() const override { return {}; }
  void drive(const DriveCommand& command) noexcept override {
    last = command;
    ++commands;
  }
  void stop() noexcept override { drive({}); }
  double forward_speed_mps() const noexcept override { return 0.30; }
  double turning_speed_radps() const noexcept override { return 1.6; }
  double turn_radius_m() const noexcept override { return 0.185; }
};

struct FakeFrameGrabber final : FrameGrabber {
  Frame picture;
  CameraGeometry camera;

  void sense(Time) noexcept override {}
  bool healthy() const noexcept override { return true; }
  std::string problem() const override { return {}; }
  const Frame& frame() const noexcept override { return picture; }
  const CameraGeometry& geometry() const noexcept override { return camera; }
};

}  // namespace galilean::robot
