#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim/headless.h"
#include "sim/programs.h"
#include "sim/report.h"
#include "sim/snapshot.h"

namespace {

using namespace galilean;
using namespace galilean::sim;

constexpr int kBadInput = 2;
constexpr int kFailed = 1;

struct Options {
  bool headless = false;
  bool json = false;
  std::string scenario = "office";
  std::string bhdl = "office_cleanup";
  std::size_t robots = 3;
  std::uint64_t seed = 1;
  double duration_s = 0;  ///< 0: the scenario's
  std::string trace;
  std::string snapshot;
  std::string snapshot_robot = "io";
};

int complain(const Error& error, int code) {
  std::cerr << "galilean-sim: " << error.message << "\n";
  return code;
}

void declare(CLI::App& app, Options& options) {
  app.add_flag("--headless", options.headless, "One contest as fast as possible, then its result");
  app.add_flag("--json", options.json, "Print the result as one JSON object");
  app.add_option("--scenario", options.scenario, "A scenario that ships, or a JSON file")
      ->capture_default_str();
  app.add_option("--bhdl", options.bhdl, "A program that ships, or a BHDL file (headless)")
      ->capture_default_str();
  app.add_option("--robots", options.robots, "How many")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "All that is random descends from it")
      ->capture_default_str();
  app.add_option("--duration", options.duration_s, "Seconds; the scenario's unless given")
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--trace", options.trace,
                 "Write poses and states, one JSON line a robot and second");
  app.add_option("--snapshot", options.snapshot, "Write what a robot sees at the start as PNG");
  app.add_option("--robot", options.snapshot_robot, "Whose eyes --snapshot uses")
      ->capture_default_str();
}

int run_headless(const Options& options, const Scenario& scenario) {
  Registry components;
  robot::add_components(components);
  const auto program = load_program(options.bhdl, components.catalog());
  if (!program) return complain(program.error(), kBadInput);
  std::ofstream trace;
  if (!options.trace.empty()) {
    trace.open(options.trace);
    if (!trace) return complain({options.trace + ": cannot be written"}, kBadInput);
  }
  HeadlessOptions how{options.robots, options.seed, scenario.rules.duration_s,
                      options.trace.empty() ? nullptr : &trace};
  if (options.duration_s > 0) how.duration_s = options.duration_s;
  auto contest = HeadlessContest::make(scenario, program.value(), how);
  if (!contest) return complain(contest.error(), kBadInput);
  const auto began = std::chrono::steady_clock::now();
  if (const auto done = contest.value()->run(); !done) return complain(done.error(), kFailed);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
  const auto result = report(*contest.value(), how, program.value(), wall.count());
  std::cout << (options.json ? result.dump(2) + "\n" : summary(result));
  return 0;
}

int take_snapshot(const Options& options, const Scenario& scenario) {
  auto world = World::make(scenario, options.robots, options.seed);
  if (!world) return complain(world.error(), kBadInput);
  std::size_t robot = 0;
  while (robot < options.robots && robot_name(robot) != options.snapshot_robot) ++robot;
  if (robot == options.robots)
    return complain(
        {"no robot '" + options.snapshot_robot + "' among " + std::to_string(options.robots)},
        kBadInput);
  Scene scene = scene_of(scenario);
  look_at(*world.value(), scene);
  Renderer renderer({}, scenario.camera, Random(options.seed).child("camera"));
  const auto frame = std::make_unique<Frame>();
  renderer.draw(scene, robot, *frame);
  const auto written = write_snapshot(*frame, options.snapshot);
  return written ? 0 : complain(written.error(), kFailed);
}

int run(const Options& options) {
  const auto scenario = load_scenario(options.scenario);
  if (!scenario) return complain(scenario.error(), kBadInput);
  if (!options.snapshot.empty()) return take_snapshot(options, scenario.value());
  return run_headless(options, scenario.value());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Galilean's simulator: an office, its robots' boards and cameras, a referee");
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  }
  return run(options);
}
