// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/check_options.h"

#include <cmath>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/seconds_of.h"

namespace galilean::expect {
namespace {

constexpr double kLongestListening_s = 1e6;

void add_live_options(CommandLine& app, CheckOptions& options) {
  app.flag("--live", options.live, "Judge the team that is running now instead of a recording");
  app.option(
      "--for",
      [&options](const std::string& text) -> Result<void> {
        const auto seconds = seconds_of(text);
        if (!seconds) return seconds.error();
        if (seconds.value() <= 0 || seconds.value() > kLongestListening_s)
          return Error{"'" + text + "' is not a time from 1ms to 1000000s"};
        options.for_s = seconds.value();
        return {};
      },
      "How long to listen with --live, such as 60s, from the first message on; without it until "
      "Ctrl-C");
  add_domain_option(app, options.domain, "with --live");
}

/// Returns what is wrong with the options together; empty if nothing is.
std::string contradiction(const CheckOptions& options) {
  if (std::isnan(options.silence_s)) return "--silence nan is no number of seconds";
  if (options.syntax && (options.live || !options.recording.empty()))
    return "--syntax judges nothing: give neither a recording nor --live.";
  if (options.syntax) return {};
  if (options.live && !options.recording.empty())
    return "Give a recording or --live, and not both.";
  if (!options.live && options.recording.empty())
    return "Name a recording, or judge the running team with --live.";
  if (!options.live && options.for_s) return "--for is for --live; a recording is read whole.";
  return {};
}

}  // namespace

std::optional<int> read_check_options(int count, const char* const* arguments,
                                      CheckOptions& options) {
  CommandLine app("Judges a recording of the team by expectations, for people and for CI.",
                  "galilean log check");
  app.option("file", options.recording, "An MCAP file").names_file(".mcap");
  app.option("--expect", options.expectations, "Files of expectations, as docs/EXPECT.md says")
      .required()
      .names_file(".expect");
  app.option("--format", options.format, "What to print")
      .one_of({"text", "junit", "tap", "json", "github"})
      .show_default();
  app.option("--junit", options.junit, "Also write the report as JUnit's XML to this file")
      .names_file(".xml");
  app.option("--problem", options.problems,
             "Report this as an error, too, such as what went wrong in the run")
      .not_empty();
  app.option("--shortage", options.shortages,
             "Report this as an error, too: why the recording is not whole")
      .not_empty();
  app.flag("--syntax", options.syntax, "Only read the expectations, and tell their mistakes");
  app.option("--silence", options.silence_s,
             "After how many seconds without a message a robot's state and variables are unknown")
      .between(0.001, 1e6)
      .show_default();
  add_live_options(app, options);
  app.describe_exit(kFailed,
                    "An expectation does not hold, there is a --problem, or a file could not be "
                    "read or written.");
  app.describe_exit(kIncomplete,
                    "None fails, but for some it cannot be told: messages are missing, a robot was "
                    "never heard, or there is a --shortage.");
  if (const auto code = app.parse(count, arguments)) return code;
  if (const auto sentence = contradiction(options); !sentence.empty()) return app.refuse(sentence);
  return std::nullopt;
}

}  // namespace galilean::expect
