// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "robot/rerun/recorded_devices.h"
#include "tests/robot/executive/test_robot.h"
#include "tests/robot/rerun/recorded_run.h"

namespace galilean::robot {

/// A robot whose ticks are recorded. Its devices give what the test sets.
class LiveRobot {
 public:
  explicit LiveRobot(bool holds_after_faults = false) : holds(holds_after_faults) {
    board.received = Time{};
    recorder.memory_each = 1;
    recorder.record(
        {.robot = "io",
         .seed = executive.seed(),
         .description = [this](ProgramId id) { return executive.description(id); },
         .break_table = [this](std::uint64_t number) { return executive.breaks().table(number); }});
  }

  ProgramId load(const std::string& text) { return executive.load(program_of(text)).value(); }
  void tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      clock.advance(std::chrono::milliseconds(50));
      board.received = clock.now();
      devices.port.give(board, answers);
      devices.drive.give(answers);
      devices.camera.give(answers);
      executive.tick();
    }
  }
  void go_by(int bumper) {
    board.bumpers = static_cast<std::uint8_t>(1 << bumper);
    tick();
    board.bumpers = 0;
    tick();
  }
  [[nodiscard]] std::string state() const { return std::string(executive.state_name()); }
  [[nodiscard]] RerunResult again() const { return run_again(recorder.ticks, test_components()); }

  SteppedClock clock;
  /// Each tick takes what it advances meanwhile.
  struct : Clock {
    mutable Duration read{};
    Duration each{};
    [[nodiscard]] Time now() const noexcept override { return Time{read += each}; }
  } stopwatch;
  RecordedDevices devices;
  ControllerStatus board;
  bool answers = true;
  const bool holds;  ///< after faults
  InputsRecorder recorder;
  Executive executive{{.components = test_components(),
                       .devices = devices.devices(),
                       .clock = clock,
                       .stopwatch = stopwatch,
                       .seed = 7,
                       .tuner = &devices,
                       .holds_after_faults = holds,
                       .observers = {&recorder}}};
};

inline void expect_same(const LiveRobot& robot) {
  const auto result = robot.again();
  if (result.divergence)
    ADD_FAILURE() << "tick " << result.divergence->tick << ": " << result.divergence->cause;
  EXPECT_EQ(result.cannot_tell, "");
  EXPECT_EQ(result.ticks, robot.recorder.ticks.size());
}

/// From each memory on a run is the same, but for programs to go back to that are not in it.
/// Returns how many runs began with one.
inline std::size_t expect_same_from_memories(const LiveRobot& robot) {
  const auto& ticks = robot.recorder.ticks;
  std::size_t runs = 0;
  for (std::size_t i = 1; i + 1 < ticks.size(); ++i) {
    if (ticks[i].memory.empty()) continue;
    const auto result =
        run_again({ticks.begin() + static_cast<std::ptrdiff_t>(i), ticks.end()}, test_components());
    if (result.divergence)
      ADD_FAILURE() << "from " << i + 1 << " in tick " << result.divergence->tick << ": "
                    << result.divergence->cause;
    const bool went_back = result.cannot_tell.find("went back") != std::string::npos;
    EXPECT_TRUE(result.cannot_tell.empty() || (went_back && ticks[i].memory[0].has_predecessor))
        << result.cannot_tell;
    ++runs;
  }
  return runs;
}

}  // namespace galilean::robot
