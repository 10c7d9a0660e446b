// SPDX-License-Identifier: BSD-3-Clause

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/robots_option.h"
#include "sim/commands.h"

namespace {

using galilean::CommandLine;
using galilean::sim::Options;

void declare_live(CommandLine& app, Options& options) {
  app.flag("--live", options.live,
           "Run in real time for robots in their own processes, and print their devices as JSON");
  app.option("--run", options.run,
             "Name of this run, which is part of the names of its serial lines and cameras (live)")
      .show_default();
  app.option("--autostart", options.autostart_s,
             "Seconds from when all robots are connected until a bumper of each is pushed (live)")
      .between(0.0, 3600.0);
  app.option("--fault", options.faults,
             "Unplug a device for a while, as camera:io@20-30 or serial:io@20-30 (live)");
  galilean::add_domain_option(app, options.domain, "live");
}

void declare(CommandLine& app, Options& options) {
  app.flag("--headless", options.headless,
           "Run one contest as fast as possible and print its result (the default)");
  app.flag("--json", options.json, "Print the result as one JSON object");
  app.option("--scenario", options.scenario, "A scenario that ships, or a JSON file")
      .names_shipped_file("scenarios", ".json")
      .show_default();
  app.option("--bhdl", options.bhdl, "A program that ships, or a BHDL file (headless)")
      .names_shipped_file("programs", ".bhdl")
      .show_default();
  galilean::add_robots_option(app, options.robots);
  app.option("--seed", options.seed, "Seed of the random number generators").show_default();
  app.option("--duration", options.duration_s,
             "Length of the contest in seconds; without it the scenario's")
      .between(0.1, 86400.0);
  app.option("--start", options.start,
             "Start from the state of a live team: a JSON file that the monitor made (headless)")
      .names_file(".json");
  app.option("--trace", options.trace,
             "Write each robot's pose and state to this file once a second, as JSON lines")
      .names_file();
  app.option("--snapshot", options.snapshot,
             "Write a robot's first camera picture to this file, as PNG")
      .names_file(".png");
  app.option("--robot", options.snapshot_robot, "The robot whose camera takes the --snapshot")
      .show_default();
}

}  // namespace

int main(int argc, char** argv) {
  galilean::CommandLine app(
      "Galilean's simulator: an office, its robots' boards and cameras, a referee", "galilean sim");
  Options options;
  declare(app, options);
  declare_live(app, options);
  app.describe_exit(galilean::kWrongUsage,
                    "The command line is wrong, or a file that it names cannot be used.");
  if (const auto code = app.parse(argc, argv)) return *code;
  return galilean::sim::run(options);
}
