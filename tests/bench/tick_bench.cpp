// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <chrono>
#include <utility>

#include "robot/executive/snapshot.h"
#include "robot/inputs/inputs_tap.h"
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

/// The office program while it wanders, with five pictures a second.
class Wanderer {
 public:
  explicit Wanderer(std::vector<TickObserver*> observers) : robot_(1, std::move(observers)) {
    paint_office(robot_.camera.picture);
    loaded_ = robot_.executive->load(shipped_program("office_cleanup.bhdl")).ok();
    robot_.tick();
    robot_.executive->push_bumper(0);
    robot_.tick(20);
  }
  [[nodiscard]] bool loaded() const noexcept { return loaded_; }
  /// Returns how many seconds a tick took.
  double tick() {
    constexpr int kTicksAPicture = 4;
    if (++ticks_ % kTicksAPicture == 0) ++robot_.camera.picture.number;
    robot_.clock.advance(std::chrono::milliseconds(50));
    const auto began = std::chrono::steady_clock::now();
    robot_.executive->tick();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

 private:
  TestRobot robot_;
  bool loaded_ = false;
  int ticks_ = 0;
};

/// Lets three robots tick in turn: one without a tap of what its ticks read, one whose inputs
/// nobody records, and one whose inputs are recorded. The figures are the ratios to the first.
void tick_beside_recorded_inputs(benchmark::State& state) {
  InputsTap unread, read;
  unread.want(false);
  Wanderer without({}), unrecorded({&unread}), recorded({&read});
  if (!without.loaded() || !unrecorded.loaded() || !recorded.loaded())
    return state.SkipWithError("the program does not load");
  double without_s = 0, unrecorded_s = 0, recorded_s = 0;
  for (auto _ : state) {
    without_s += without.tick();
    unrecorded_s += unrecorded.tick();
    recorded_s += recorded.tick();
    for (TickRecord record; read.take(record);) benchmark::DoNotOptimize(record);
  }
  state.counters["unrecorded"] = unrecorded_s / without_s;
  state.counters["recorded"] = recorded_s / without_s;
  state.counters["lost"] = static_cast<double>(read.lost());
}
BENCHMARK(tick_beside_recorded_inputs)->Unit(benchmark::kMicrosecond);

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
