// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "core/clock.h"
#include "robot/devices/byte_pipe.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "robot/firmware/controller.h"
#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot {

/// The real firmware with bench motors behind a pipe, and a robot's devices before it, on a stepped
/// clock. It runs in steps of a millisecond, as the headless simulator does.
class BoardOnAPipe {
 public:
  static constexpr int kTick_ms = 20;

  BoardOnAPipe() { power_up(); }

  /// Restarts the board: encoders and parameters begin anew, and its time at `uptime_ms`.
  void power_up(std::uint32_t uptime_ms = 0) {
    bench_ = {};
    controller_.emplace(bench_, firmware::Controller::Identity{{'i', 'o'}, ++boots_});
    board_ms_ = uptime_ms;
  }
  /// Puts another board in its place, which was started as often and runs for `uptime_ms`.
  void replace_board(std::uint32_t uptime_ms) {
    bench_ = {};
    controller_.emplace(bench_, firmware::Controller::Identity{{'e', 'u'}, boots_});
    board_ms_ = uptime_ms;
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      run_traffic(1);
      if (i % kTick_ms == 0) link.sense(now_);
    }
  }
  /// Runs the line and the board without `sense`.
  void run_traffic(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      now_ += std::chrono::milliseconds(1);
      link.pump(now_);
      if (board_runs) step_board();
    }
  }
  /// Runs the board alone: the robot's process is stopped.
  void stand_still(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      now_ += std::chrono::milliseconds(1);
      step_board();
    }
  }
  /// Runs with a command each tick, as a control loop does.
  void keep_driving(const DriveCommand& command, int milliseconds) {
    for (int i = 0; i < milliseconds; i += kTick_ms) {
      drive.drive(command);
      run(kTick_ms);
    }
  }
  /// Runs with one command, which is renewed each tick.
  void drive_once(const DriveCommand& command, int milliseconds) {
    drive.drive(command);
    for (int i = 0; i < milliseconds; i += kTick_ms) {
      run(kTick_ms);
      drive.keep_moving();
    }
  }
  firmware::BenchBoard& bench() { return bench_; }

  BytePipe pipe{"bench line"};
  MicrocontrollerLink link{pipe.robot_end(), CommPortSettings{}};
  MotorDriveSettings settings;
  WheelDrive drive{link, settings};
  bool board_runs = true;
  bool board_reads = true;  ///< false: the line to the board is blocked; what it says gets through

 private:
  void step_board() {
    std::array<std::uint8_t, 256> bytes;
    const auto count = board_reads ? pipe.board_end().read(bytes) : 0;
    bench_.to_board.insert(bench_.to_board.end(), bytes.begin(),
                           bytes.begin() + static_cast<std::ptrdiff_t>(count));
    controller_->update(++board_ms_);
    bench_.step(0.001);
    pipe.board_end().write(bench_.from_board);
    bench_.from_board.clear();
  }

  firmware::BenchBoard bench_;
  std::optional<firmware::Controller> controller_;
  std::uint16_t boots_ = 0;
  std::uint32_t board_ms_ = 0;
  Time now_{};
};

}  // namespace galilean::robot
