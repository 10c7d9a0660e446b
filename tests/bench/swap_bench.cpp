// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <spdlog/spdlog.h>

#include <fstream>

#include "robot/control_loop.h"
#include "robot/executive/snapshot.h"
#include "robot/telemetry/image_tap.h"
#include "robot/watch/program_watch.h"
#include "tests/robot/executive/office.h"
#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

using Stopwatch = std::chrono::steady_clock;

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// The office program on scripted devices, with all its observers.
class SwappedRobot {
 public:
  SwappedRobot() : robot_(1, {&snapshots_, &images_}) { paint_office(robot_.camera.picture); }

  void load(bhdl::Program program) {
    if (!robot_.executive->load(std::move(program))) throw std::runtime_error("refused");
  }
  double timed_tick_us() {
    ++robot_.camera.picture.number;
    robot_.clock.advance(std::chrono::milliseconds(50));
    const auto begin = Stopwatch::now();
    robot_.executive->tick();
    const auto end = Stopwatch::now();
    while (snapshots_.next_event()) {
    }
    return std::chrono::duration<double, std::micro>(end - begin).count();
  }
  Executive& executive() { return *robot_.executive; }

 private:
  SnapshotTap snapshots_;
  ImageTap images_{test_components().catalog()};
  TestRobot robot_;
};

/// Compares ticks that exchange programs with ticks that do not, in microseconds.
void tick_that_exchanges(benchmark::State& state, bool roll_back) {
  const auto wander = shipped_program("office_cleanup.bhdl");
  const auto spin = shipped_program("sit_and_spin.bhdl");
  std::vector<double> plain;
  std::vector<double> exchanging;
  SwappedRobot robot;
  robot.load(wander);
  robot.timed_tick_us();
  for (bool odd = false; auto _ : state) {
    odd = !odd;
    for (int i = 0; i < 10; ++i) plain.push_back(robot.timed_tick_us());
    robot.load(odd ? spin : wander);
    const double swapping = robot.timed_tick_us();
    if (roll_back) robot.executive().roll_back(robot.executive().running(), "by the benchmark");
    exchanging.push_back(roll_back ? robot.timed_tick_us() : swapping);
  }
  state.counters["plain_us"] = quantile(plain, 0.5);
  state.counters["exchanging_us"] = quantile(exchanging, 0.5);
  state.counters["ratio"] = quantile(exchanging, 0.5) / quantile(plain, 0.5);
}
BENCHMARK_CAPTURE(tick_that_exchanges, by_a_swap, false)->Iterations(500);
BENCHMARK_CAPTURE(tick_that_exchanges, by_a_rollback, true)->Iterations(500);

/// Lets a thread wait for the tick that swaps.
class SwapSignal final : public TickObserver {
 public:
  void on_event(const Event& event) noexcept override {
    if (event.kind != Event::Kind::kSwapped) return;
    at_.store(Stopwatch::now().time_since_epoch().count());
    swaps_.store(swaps_.load() + 1);
    swaps_.notify_one();
  }
  void on_tick(const TickView&) noexcept override {}
  [[nodiscard]] int swaps() const { return swaps_.load(); }
  [[nodiscard]] Stopwatch::time_point wait_beyond(int swaps) const {
    swaps_.wait(swaps);
    return Stopwatch::time_point(Stopwatch::duration(at_.load()));
  }

 private:
  std::atomic<std::int64_t> at_{0};
  std::atomic<int> swaps_{0};
};

/// Measures from an editor's save (written to another file, renamed) to the end of the new
/// program's first tick. The control loop runs at its usual twenty ticks a second.
void save_until_in_effect(benchmark::State& state) {
  spdlog::set_level(spdlog::level::off);
  const TemporaryFolder folder;
  const auto file = folder / "watched.bhdl";
  const auto save = [&](int number) {
    std::ofstream(folder / "aside")
        << "include \"" GALILEAN_SOURCE_DIR "/bhdl/programs/office_cleanup.bhdl\" ; " << number;
    const auto begin = Stopwatch::now();
    std::filesystem::rename(folder / "aside", file);
    return begin;
  };
  save(0);
  ScriptedPort port;
  ScriptedDrive drive;
  ScriptedCamera camera;
  const SteadyClock clock;
  SwapSignal signal;
  Wake wake;
  Executive executive({.components = test_components(),
                       .devices = {port, drive, camera},
                       .clock = clock,
                       .stopwatch = clock,
                       .observers = {&signal},
                       .on_waiting = [&wake] { wake.ring(); }});
  auto checked = bhdl::check_file(file, test_components().catalog());
  if (!checked.program || !executive.load(std::move(*checked.program)))
    return state.SkipWithError("the program does not load");
  const ControlLoop loop(std::chrono::milliseconds(50), wake, [&] { executive.tick(); });
  while (executive.waiting()) std::this_thread::yield();
  const ProgramWatch watch(file, test_components().catalog(), executive, [](const std::string&) {});
  std::vector<double> latencies_ms;
  for (int number = 1; auto _ : state) {
    std::this_thread::sleep_for(std::chrono::milliseconds(7));
    const int before = signal.swaps();
    const auto begin = save(number++);
    latencies_ms.push_back(
        std::chrono::duration<double, std::milli>(signal.wait_beyond(before) - begin).count());
  }
  state.counters["median_ms"] = quantile(latencies_ms, 0.5);
  state.counters["p99_ms"] = quantile(latencies_ms, 0.99);
  state.counters["longest_ms"] = quantile(latencies_ms, 1);
}
BENCHMARK(save_until_in_effect)->Iterations(500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::robot
