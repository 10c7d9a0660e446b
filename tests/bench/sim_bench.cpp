// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "robot/components.h"
#include "sim/headless/headless.h"
#include "sim/headless/programs.h"

namespace {

using namespace galilean;
using namespace galilean::sim;

void draw_office(benchmark::State& state) {
  const Scenario office = load_scenario("office").value();
  const auto world = World::make(office, 3, 1);
  Scene scene = scene_of(office);
  look_at(*world.value(), scene);
  Renderer renderer({}, office.camera, Random(1));
  const auto frame = std::make_unique<Frame>();
  for (auto _ : state) {
    scene.robot_poses[0].heading_rad += 0.01;
    renderer.draw(scene, 0, *frame);
    benchmark::DoNotOptimize(frame->rgb.data());
  }
}
BENCHMARK(draw_office)->Unit(benchmark::kMicrosecond);

void step_world(benchmark::State& state) {
  const auto world = World::make(load_scenario("office").value(), 3, 1);
  for (std::size_t i = 0; i < 3; ++i) world.value()->robot(i).apply({500, 450, 0});
  for (auto _ : state) world.value()->step();
}
BENCHMARK(step_world)->Unit(benchmark::kMicrosecond);

/// Runs three whole robots with full vision. The rate is simulated seconds a second.
void contest(benchmark::State& state) {
  Registry components;
  robot::add_components(components);
  const auto program = load_program("office_cleanup", components.catalog()).value();
  const Scenario office = load_scenario("office").value();
  constexpr double kSeconds = 60;
  for (auto _ : state) {
    auto made = HeadlessContest::make(office, components, program,
                                      {.robots = 3, .seed = 1, .duration_s = kSeconds});
    benchmark::DoNotOptimize(made.value()->run().ok());
  }
  state.counters["simulated_seconds"] = benchmark::Counter(
      kSeconds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(contest)->Unit(benchmark::kMillisecond);

}  // namespace
