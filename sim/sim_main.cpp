// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "sim/commands.h"

namespace {

using galilean::sim::Options;

void declare_live(CLI::App& app, Options& options) {
  app.add_flag("--live", options.live,
               "In real time, for robots in processes of their own; prints their devices as JSON");
  app.add_option("--run", options.run, "Part of the names of lines and cameras (live)")
      ->capture_default_str();
  app.add_option("--autostart", options.autostart_s,
                 "Push a bumper of each robot so many seconds after all are connected (live)")
      ->check(CLI::Range(0.0, 3600.0));
  app.add_option("--fault", options.faults,
                 "Unplug a device for a while, as camera:io@20-30 or serial:io@20-30 (live)");
  app.add_option("--domain", options.domain, "DDS domain; ROS_DOMAIN_ID unless given (live)")
      ->check(CLI::Range(0, 232));
}

void declare(CLI::App& app, Options& options) {
  app.add_flag("--headless", options.headless,
               "One contest as fast as possible, then its result (the default)");
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
  app.add_option("--start", options.start,
                 "Go on from where a live team is: a JSON file as the monitor makes it (headless)");
  app.add_option("--trace", options.trace,
                 "Write poses and states, one JSON line a robot and second");
  app.add_option("--snapshot", options.snapshot, "Write what a robot sees at the start as PNG");
  app.add_option("--robot", options.snapshot_robot, "Whose eyes --snapshot uses")
      ->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Galilean's simulator: an office, its robots' boards and cameras, a referee");
  Options options;
  declare(app, options);
  declare_live(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : galilean::sim::kBadInput;
  }
  return galilean::sim::run(options);
}
