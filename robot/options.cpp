// SPDX-License-Identifier: BSD-3-Clause
#include "robot/options.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/wire/robot_name.h"
#include "robot/executive/probation.h"

namespace galilean::robot {
namespace {

Result<void> check_name(const std::string& name) {
  if (msg::is_robot_name(name)) return {};
  return Error{
      "a robot's name consists of 1 to 64 letters, digits and _, and does not begin with a digit"};
}

/// Returns the device as the frame source names it. It calls the simulator's shared memory
/// "ring:/name".
std::string camera_device(const std::string& given) {
  constexpr std::string_view kShared = "shm:";
  if (!given.starts_with(kShared)) return given;
  const std::string name = given.substr(kShared.size());
  return "ring:" + (name.starts_with('/') ? name : "/" + name);
}

/// The keys that all robots of a machine trust.
constexpr const char* kTrustOfMachine = "/etc/galilean/team.keys";

/// Returns the file that counts where --trust is not given; empty if there is none. One that is
/// there but cannot be read is named, too, so that the robot does not start without it.
std::string usual_trust_file() {
  if (const char* named = std::getenv("GALILEAN_TRUST"); named && *named) return named;
  std::error_code unknown;
  const auto kind = std::filesystem::symlink_status(kTrustOfMachine, unknown).type();
  return kind == std::filesystem::file_type::not_found ? "" : kTrustOfMachine;
}

/// While watching, the file that is named stands for both if only one of the two is named.
void settle_files(Options& options, bool watching) {
  if (!watching) return;
  if (options.watched_file.empty()) options.watched_file = options.bhdl_file;
  if (options.bhdl_file.empty()) options.bhdl_file = options.watched_file;
}

}  // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  Options options;
  std::string serial;
  std::string camera;
  CommandLine app("Runs one robot from a BHDL program.", "galilean robot");
  app.option("--name", options.name, "the robot's name, which is part of its topics' names")
      .check(check_name)
      .show_default();
  app.option("--bhdl", options.bhdl_file, "the BHDL program that the robot runs")
      .names_file(".bhdl");
  const auto watch =
      app.option("--watch", options.watched_file,
                 "swap whenever this program, or one that it includes, is saved [the --bhdl one]")
          .takes(0, 1)
          .names_file(".bhdl");
  app.option("--serial", serial, "serial device of the microcontroller [the program's]")
      .names_file();
  app.option("--camera", camera,
             "shm:NAME for the simulator's, /dev/videoN, or a video or picture file "
             "[the program's]")
      .names_file();
  add_domain_option(app, options.domain);
  app.option("--seed", options.seed, "seed of the random number generators").show_default();
  app.option("--rate", options.rate_hz, "ticks per second of the control loop")
      .between(1.0, 1000.0)
      .show_default();
  app.option("--probation", options.probation_s,
             "how many seconds a new program may still be rolled back if it fails")
      .between(0.0, 3600.0)
      .show_default();
  app.option(
         "--max-transitions", options.most_transitions_per_s,
         "how many changes of state per second a new program may make before it counts as failed")
      .between(1, ProbationRules::kMostCounted)
      .show_default();
  app.flag(
      "--resume-by-itself", options.resumes_by_itself,
      "go on by itself after a fault of the line, the board, the camera or this program that "
      "lasted over 1 s, for robots that nobody attends, but not after an operator's stop; else "
      "the robot is held until somebody resumes it or pushes a bumper");
  app.flag("--fresh", options.fresh,
           "begin with the --bhdl program also after a crash; else the one that was pushed and "
           "confirmed last runs again");
  app.flag("--keep-nothing", options.keeps_nothing,
           "keep nothing on disk for a start after a crash, and begin as if there had been none");
  app.option("--accept-swaps-from", options.accept_swaps_from,
             "which processes may send programs over DDS: 'any', or the names of DDS participants, "
             "such as monitor,swap [monitor]")
      .divided_by(',');
  app.option("--trust", options.trust_file,
             "obey only those whose public keys are in this file, a line each, as 'galilean keys' "
             "prints it; anybody may still stop the robot [GALILEAN_TRUST, else "
             "/etc/galilean/team.keys where that is there]")
      .names_file();
  app.option("--log-level", options.log_level, "the least severe messages that are logged")
      .one_of({"debug", "info", "warning", "error", "off"})
      .show_default();
  app.flag("--print-catalog", options.print_catalog,
           "print the components that a program may name, as JSON, and exit");
  if (const auto code = app.parse(argc, argv)) return {std::nullopt, *code};
  settle_files(options, watch.given());
  if (options.trust_file.empty()) options.trust_file = usual_trust_file();
  if (options.bhdl_file.empty() && !options.print_catalog) {
    std::cerr << "galilean-robot: --bhdl FILE is missing: name the program to run\n";
    return {std::nullopt, kWrongUsage};
  }
  if (!serial.empty()) options.serial = serial;
  if (!camera.empty()) options.camera = camera_device(camera);
  return {options, 0};
}

}  // namespace galilean::robot
