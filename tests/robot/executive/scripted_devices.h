// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>

#include "core/device/camera_geometry.h"
#include "core/device/comm_port.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {

/// Devices that report what a test sets, and keep the commands that they get.
class ScriptedPort final : public CommPort {
 public:
  void sense(Time now) noexcept override {
    sensed = next;
    sensed.received = now;
    if (on_sense) on_sense();
  }
  [[nodiscard]] bool healthy() const noexcept override { return answers; }
  [[nodiscard]] std::string problem() const override { return answers ? "" : "unplugged"; }
  [[nodiscard]] const ControllerStatus& status() const noexcept override { return sensed; }
  void command_gripper(GripperCommand command) noexcept override { gripper = command; }

  ControllerStatus next;
  ControllerStatus sensed;
  GripperCommand gripper = GripperCommand::kOpen;
  std::atomic<bool> answers = true;
  std::function<void()> on_sense;  ///< runs right after the executive exchanged programs
};

class ScriptedDrive final : public MotorDrive {
 public:
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return answers; }
  [[nodiscard]] std::string problem() const override { return ""; }
  void drive(const DriveCommand& command) noexcept override {
    last = command;
    moving = command.speed_mps != 0 || command.turn_rate_radps != 0;
    ++commands;
  }
  void keep_moving() noexcept override { ++renewals; }
  void stop() noexcept override {
    last = {};
    moving = false;
  }
  [[nodiscard]] double forward_speed_mps() const noexcept override { return 0.3; }
  [[nodiscard]] double turning_speed_radps() const noexcept override { return 1; }
  [[nodiscard]] double turn_radius_m() const noexcept override { return 0.2; }

  DriveCommand last;
  bool moving = false;
  int commands = 0;
  int renewals = 0;
  std::atomic<bool> answers = true;
};

class ScriptedCamera final : public FrameGrabber {
 public:
  void sense(Time now) noexcept override { picture.captured = now; }
  [[nodiscard]] bool healthy() const noexcept override { return answers; }
  [[nodiscard]] std::string problem() const override { return answers ? "" : "lens cap on"; }
  [[nodiscard]] const Frame& frame() const noexcept override { return picture; }
  [[nodiscard]] const CameraGeometry& geometry() const noexcept override { return camera; }

  Frame picture;
  CameraGeometry camera;
  std::atomic<bool> answers = true;
};

}  // namespace galilean::robot
