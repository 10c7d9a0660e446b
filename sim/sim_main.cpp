// SPDX-License-Identifier: BSD-3-Clause

#include "core/command_line/command_line.h"
#include "sim/commands.h"

namespace {

using galilean::CommandLine;
using galilean::sim::Options;

void declare_live(CommandLine& app, Options& options) {
  app.flag("--live", options.live,
           "In real time, for robots in processes of their own; prints their devices as JSON");
  app.option("--run", options.run, "Part of the names of lines and cameras (live)").show_default();
  app.option("--autostart", options.autostart_s,
             "Push a bumper of each robot so many seconds after all are connected (live)")
      .between(0.0, 3600.0);
  app.option("--fault", options.faults,
             "Unplug a device for a while, as camera:io@20-30 or serial:io@20-30 (live)");
  app.option("--domain", options.domain, "DDS domain; ROS_DOMAIN_ID unless given (live)")
      .between(0, 232);
}

void declare(CommandLine& app, Options& options) {
  app.flag("--headless", options.headless,
           "One contest as fast as possible, then its result (the default)");
  app.flag("--json", options.json, "Print the result as one JSON object");
  app.option("--scenario", options.scenario, "A scenario that ships, or a JSON file")
      .show_default();
  app.option("--bhdl", options.bhdl, "A program that ships, or a BHDL file (headless)")
      .show_default();
  app.option("--robots", options.robots, "How many").between(1, 64).show_default();
  app.option("--seed", options.seed, "All that is random descends from it").show_default();
  app.option("--duration", options.duration_s, "Seconds; the scenario's unless given")
      .between(0.1, 86400.0);
  app.option("--start", options.start,
             "Go on from where a live team is: a JSON file as the monitor makes it (headless)");
  app.option("--trace", options.trace, "Write poses and states, one JSON line a robot and second");
  app.option("--snapshot", options.snapshot, "Write what a robot sees at the start as PNG");
  app.option("--robot", options.snapshot_robot, "Whose eyes --snapshot uses").show_default();
}

}  // namespace

int main(int argc, char** argv) {
  galilean::CommandLine app(
      "Galilean's simulator: an office, its robots' boards and cameras, a referee");
  Options options;
  declare(app, options);
  declare_live(app, options);
  if (const auto code = app.parse(argc, argv)) return *code == 0 ? 0 : galilean::sim::kBadInput;
  return galilean::sim::run(options);
}
