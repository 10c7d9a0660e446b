// SPDX-License-Identifier: BSD-3-Clause
#include "sim/commands.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/broken_pipe.h"
#include "core/installation.h"
#include "core/json_text.h"
#include "core/state_folder.h"
#include "core/written_files.h"
#include "robot/components.h"
#include "sim/headless/headless.h"
#include "sim/headless/programs.h"
#include "sim/headless/report.h"
#include "sim/live/live.h"
#include "sim/live/snapshot.h"
#include "sim/scenario/enlarge.h"

namespace galilean::sim {
namespace {

std::atomic<bool> ending{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler writes it");

int complain(const Error& error, int code) {
  std::cerr << "galilean-sim: " << error.message << "\n";
  return code;
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
  HeadlessOptions how{options.robots, options.seed, scenario.rules.duration_s, nullptr,
                      options.trace.empty() ? nullptr : &trace};
  if (options.duration_s > 0) how.duration_s = options.duration_s;
  std::optional<TeamSituation> start;
  if (!options.start.empty()) {
    auto loaded = load_situation(options.start);
    if (!loaded) return complain(loaded.error(), kBadInput);
    start = std::move(loaded).value();
    how.start = &*start;
    how.robots = start->robots.size();
  }
  auto contest =
      HeadlessContest::make(enlarged_for(scenario, how.robots), components, program.value(), how);
  if (!contest) return complain(contest.error(), kBadInput);
  const auto began = std::chrono::steady_clock::now();
  if (const auto done = contest.value()->run(); !done) return complain(done.error(), kFailed);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - began;
  const auto result = report(*contest.value(), how, program.value(), wall.count());
  std::cout << (options.json ? ordered_json_text(result, 2) + "\n" : summary(result));
  return 0;
}

int take_snapshot(const Options& options, const Scenario& shipped) {
  const Scenario scenario = enlarged_for(shipped, options.robots);
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

Result<std::vector<DeviceFault>> parse_faults(const Options& options) {
  std::vector<DeviceFault> faults;
  for (const auto& text : options.faults) {
    auto fault = parse_fault(text);
    if (!fault) return fault.error();
    faults.push_back(fault.value());
  }
  return faults;
}

int run_live(const Options& options, const Scenario& scenario) {
  auto faults = parse_faults(options);
  if (!faults) return complain(faults.error(), kBadInput);
  Scenario timed = enlarged_for(scenario, options.robots);
  if (options.duration_s > 0) timed.rules.duration_s = options.duration_s;
  ignore_broken_pipes();
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    std::signal(number, [](int) { ending = true; });
  auto contest = LiveContest::make(
      timed, {options.robots, options.seed, options.run, options.autostart_s, options.domain,
              std::move(faults).value(), state_folder() / "boards"});
  if (!contest) return complain(contest.error(), kBadInput);
  std::cout << contest.value()->ready_line() << std::endl;
  contest.value()->run(ending);
  std::cout << contest.value()->score_line() << std::endl;
  return 0;
}

/// Errors: a file is to be written that is read, too.
Result<void> check_files(const Options& options) {
  auto read = bhdl::files_of(find_file(options.bhdl, "programs", ".bhdl"));
  read.push_back(find_file(options.scenario, "scenarios", ".json").string());
  read.push_back(options.start);
  return check_written_files({options.trace, options.snapshot}, read);
}

}  // namespace

int run(const Options& options) {
  if (options.live && options.headless)
    return complain({"--live and --headless exclude one another"}, kBadInput);
  if (const auto right = check_files(options); !right) return complain(right.error(), kBadInput);
  const auto scenario = load_scenario(options.scenario);
  if (!scenario) return complain(scenario.error(), kBadInput);
  if (!options.snapshot.empty()) return take_snapshot(options, scenario.value());
  if (options.live) return run_live(options, scenario.value());
  return run_headless(options, scenario.value());
}

}  // namespace galilean::sim
