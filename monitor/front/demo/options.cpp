// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/options.h"

#include <filesystem>

#include "bhdl/check.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/robots_option.h"
#include "core/installation.h"
#include "core/visible_text.h"
#include "core/written_files.h"

namespace galilean::front {
namespace {

namespace fs = std::filesystem;

/// The recorder would refuse it, too, but only when the team is running.
std::string recording_in_the_way(const std::string& record) {
  std::error_code unknown;
  if (record == "-") return "--record needs the name of a file";
  const bool is_there = fs::exists(fs::symlink_status(record, unknown));
  if (record.empty() || !is_there || fs::is_other(record, unknown)) return {};
  return record + " exists already; choose another name for --record";
}

/// Errors: a file is to be written that is read, too, or twice.
Result<void> check_files(const DemoOptions& options) {
  auto read = bhdl::files_of(find_file(options.bhdl, "programs", ".bhdl"));
  read.push_back(find_file(options.scenario, "scenarios", ".json").string());
  for (const auto& each : options.expectations)
    read.push_back(find_file(each, "expectations", ".expect").string());
  return check_written_files({options.record, options.junit}, read);
}

/// Returns what is wrong with the options together; an empty text if nothing is.
std::string contradiction(const DemoOptions& options) {
  if (!options.expectations.empty() && !options.headless_for_s)
    return "--expect judges a run that ends: give --headless-for, too";
  if (!options.junit.empty() && options.expectations.empty()) return "--junit needs --expect";
  if (const auto right = check_files(options); !right) return right.error().message;
  return recording_in_the_way(options.record);
}

}  // namespace

std::optional<int> read_options(int count, const char* const* arguments, DemoOptions& options) {
  CommandLine app("Starts the simulator, robots and the monitor on this machine; Ctrl-C ends all.",
                  "galilean demo");
  add_robots_option(app, options.robots);
  app.option("--port", options.port, "Port of the page on 127.0.0.1")
      .between(1, 65535)
      .show_default();
  app.option("--scenario", options.scenario, "A scenario that ships, or a JSON file")
      .names_shipped_file("scenarios", ".json")
      .show_default();
  app.option("--bhdl", options.bhdl, "A program that ships, or a BHDL file")
      .names_shipped_file("programs", ".bhdl")
      .show_default();
  app.flag("--watch", options.watch, "Swap the robots' program whenever it is saved");
  app.option("--seed", options.seed, "Seed of the random number generators").show_default();
  app.option("--headless-for", options.headless_for_s,
             "End after this many seconds, with exit code 0 if the team worked")
      .positive();
  app.option("--record", options.record, "Record all topics to this file, as MCAP")
      .names_file(".mcap");
  app.option("--expect", options.expectations,
             "Judge the recording of a headless run by these expectations: files, or those that "
             "ship")
      .names_shipped_file("expectations", ".expect");
  app.option("--junit", options.junit, "Write what came of them as JUnit's XML to this file, too")
      .names_file(".xml");
  app.option("--allow-origin", options.allowed_origins,
             "Another page that may use the monitor, as https://host[:port]")
      .not_empty();
  add_domain_option(app, options.domain);
  app.describe_exit(
      kFailed,
      "The team did not work, no robot could run the program, or an expectation does not "
      "hold.");
  app.describe_exit(kIncomplete,
                    "The team worked, and for some expectations it cannot be told, or messages are "
                    "missing in the recording.");
  if (const auto code = app.parse(count, arguments)) return code;
  if (const auto sentence = contradiction(options); !sentence.empty()) return app.refuse(sentence);
  return std::nullopt;
}

}  // namespace galilean::front
