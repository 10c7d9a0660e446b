// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "robot/devices/byte_pipe.h"
#include "robot/firmware/controller.h"
#include "robot/robot_devices.h"
#include "tests/robot/count_allocations.h"
#include "tests/robot/executive/office.h"
#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot {

/// Shows the office with its red can in every frame.
class PaintedOffice final : public FrameSource {
 public:
  bool grab(Frame& frame, Time) override {
    paint_office(frame);
    return true;
  }
  [[nodiscard]] std::string problem() const override { return {}; }
};

/// An executive on a robot's own devices, with the real firmware behind the serial line, all on a
/// stepped clock. The test moves bytes and pictures between the ticks.
class BenchRobot {
 public:
  /// Returns how often so many ticks allocate and release memory.
  long run_ticks(int times) {
    long allocations = 0;
    for (int i = 0; i < times; ++i) {
      run_traffic();
      bench_.bumpers = i % 40 == 3 ? 1 : 0;
      bench_.beam_broken = i % 60 > 30;
      const AllocationCount count;
      executive.tick();
      allocations += count.so_far();
    }
    return allocations;
  }

  SteppedClock clock;
  BytePipe line{"bench line"};
  PaintedOffice office;
  RobotDevices devices{line.robot_end(), office, DeviceSettings{}};
  Executive executive{ExecutiveSetup{.components = test_components(),
                                     .devices = devices.devices(),
                                     .clock = clock,
                                     .stopwatch = clock,
                                     .tuner = &devices}};

 private:
  void run_traffic() {
    for (int ms = 0; ms < 50; ++ms) {
      clock.advance(std::chrono::milliseconds(1));
      devices.pump_line(clock.now());
      std::array<std::uint8_t, 256> bytes;
      const auto count = line.board_end().read(bytes);
      bench_.to_board.insert(bench_.to_board.end(), bytes.begin(),
                             bytes.begin() + static_cast<std::ptrdiff_t>(count));
      controller_.update(++board_ms_);
      bench_.step(0.001);
      line.board_end().write(bench_.from_board);
      bench_.from_board.clear();
    }
    devices.pump_camera(clock.now());
  }

  firmware::BenchBoard bench_;
  firmware::Controller controller_{bench_, {{'i', 'o'}, 1}};
  std::uint32_t board_ms_ = 0;
};

}  // namespace galilean::robot
