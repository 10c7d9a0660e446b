// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "robot/executive/snapshot.h"
#include "robot/telemetry/image_tap.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

/// Runs a tick of the whole office program while it wanders, with all its observers.
void tick_of_the_office_program(benchmark::State& state, bool frames) {
  SnapshotTap snapshots;
  ImageTap images(test_components().catalog());
  TestRobot robot(1, {&snapshots, &images});
  paint_office(robot.camera.picture);
  if (!robot.executive->load(shipped_program("office_cleanup.bhdl")))
    return state.SkipWithError("the program does not load");
  robot.tick();
  robot.executive->push_bumper(0);
  robot.tick(20);
  for (auto _ : state) {
    if (frames) ++robot.camera.picture.number;
    robot.clock.advance(std::chrono::milliseconds(50));
    robot.executive->tick();
  }
  state.SetLabel(std::string(robot.executive->state_name()));
}
BENCHMARK_CAPTURE(tick_of_the_office_program, without_a_frame, false)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tick_of_the_office_program, with_a_frame, true)->Unit(benchmark::kMicrosecond);

/// Checks, builds and swaps the office program and the other strategy in turn.
void swap_of_strategies(benchmark::State& state) {
  TestRobot robot;
  const auto wander = shipped_program("office_cleanup.bhdl");
  const auto spin = shipped_program("sit_and_spin.bhdl");
  for (bool odd = false; auto _ : state) {
    odd = !odd;
    if (!robot.executive->load(odd ? wander : spin)) state.SkipWithError("refused");
    robot.tick();
  }
}
BENCHMARK(swap_of_strategies)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace galilean::robot
