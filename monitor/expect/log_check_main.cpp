// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/seconds_of.h"
#include "core/json_text.h"
#include "core/progress_bar.h"
#include "core/written_files.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/expectation_files.h"
#include "monitor/expect/live/live_samples.h"
#include "monitor/expect/recording/play_samples.h"
#include "monitor/expect/report/report.h"

namespace {

using namespace galilean;
using namespace galilean::expect;

struct Options {
  std::string recording;
  std::vector<std::string> expectations;
  std::string format = "text";
  std::string junit;
  double silence_s = 2;
  bool syntax = false;  ///< only read the expectations
  bool live = false;
  std::optional<double> for_s;  ///< live: nothing for "until termination is asked for"
  int domain = -1;
};

constexpr double kLongest_s = 1e6;

int fail(const std::string& sentence) {
  std::cerr << "galilean-log-check: " << sentence << '\n';
  return kFailed;
}

std::string in_format(const std::string& format, const Report& report) {
  if (format == "junit") return junit_report(report);
  if (format == "tap") return tap_report(report);
  if (format == "json") return json_report(report);
  if (format == "github") return github_report(report);
  return text_report(report);
}

/// Prints mistakes in the expectations, for programs where programs read.
void print(const std::vector<bhdl::Diagnostic>& diagnostics, const Options& options) {
  for (const auto& each : diagnostics) std::cerr << bhdl::format(each) << '\n';
  if (options.format == "json") std::cout << json_text({{"diagnostics", diagnostics}}, 2) << '\n';
}

Result<void> write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (file << text && file.flush()) return {};
  return Error{"cannot write " + path};
}

int exit_code(const Judgement& judgement) {
  if (judgement.count(Outcome::kFails) > 0) return kFailed;
  return judgement.count(Outcome::kCannotTell) > 0 ? kIncomplete : 0;
}

Result<Played> read_recording(const Options& options, Judge& judge) {
  const auto file = mcap::FileSource::open(options.recording);
  if (!file) return file.error();
  const auto bar = progress_on_terminal("judging " + options.recording);
  const auto show = [&](double done) {
    if (bar) bar->show(done);
  };
  const auto summary = mcap::summarize(file.value(), mcap::Depth::kAsNeeded, show);
  if (!summary) return Error{options.recording + " " + summary.error().message};
  return play_samples(file.value(), summary.value(), judge, show);
}

Result<Played> hear_team(const Options& options, Judge& judge) {
  const auto session = monitor::WireSession::join(options.domain, "check");
  if (!session) return session.error();
  return listen(*session.value(), judge, from_seconds(options.for_s.value_or(kLongest_s)));
}

int tell(const Options& options, const Judgement& judgement) {
  const Report report{options.live ? "the live team" : options.recording, judgement, options.live};
  std::cout << in_format(options.format, report);
  if (!options.junit.empty())
    if (auto done = write_file(options.junit, junit_report(report)); !done)
      return fail(done.error().message);
  return std::cout.flush() ? exit_code(judgement) : kFailed;
}

/// Errors: the report is to be written over what is read.
Result<void> check_files(const Options& options) {
  auto read = options.expectations;
  read.push_back(options.recording);
  return check_written_files({options.junit}, read);
}

int run(const Options& options) try {
  if (const auto right = check_files(options); !right) return fail(right.error().message);
  const auto parsed = parse_files(options.expectations);
  if (!parsed.ok()) return print(parsed.diagnostics, options), kFailed;
  if (options.syntax) return 0;
  Judge judge(parsed.expectations, {.silence = from_seconds(options.silence_s)});
  auto played = options.live ? hear_team(options, judge) : read_recording(options, judge);
  if (!played) return fail(played.error().message);
  auto judgement = judge.finish(played.value().begin_ns, played.value().end_ns);
  judgement.silences = played.value().silences;
  std::ranges::copy(played.value().notes, std::back_inserter(judgement.notes));
  return tell(options, judgement);
} catch (const std::exception& error) {
  return fail(error.what());
}

void add_live_options(CommandLine& app, Options& options) {
  app.flag("--live", options.live, "Judge the team that is running now instead of a recording");
  app.option(
      "--for",
      [&options](const std::string& text) -> Result<void> {
        const auto seconds = seconds_of(text);
        if (!seconds) return seconds.error();
        if (seconds.value() <= 0 || seconds.value() > kLongest_s)
          return Error{"'" + text + "' is not a time from 1ms to 1000000s"};
        options.for_s = seconds.value();
        return {};
      },
      "How long to listen with --live, such as 60s, from the first message on; without it until "
      "Ctrl-C");
  add_domain_option(app, options.domain, "with --live");
}

/// Returns what is wrong with the options together; empty if nothing is.
std::string contradiction(const Options& options) {
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

int main(int argc, char** argv) {
  Options options;
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
  app.flag("--syntax", options.syntax, "Only read the expectations, and tell their mistakes");
  app.option("--silence", options.silence_s,
             "After how many seconds without a message a robot's state and variables are unknown")
      .between(0.001, 1e6)
      .show_default();
  add_live_options(app, options);
  app.describe_exit(kFailed,
                    "An expectation does not hold, or a file could not be read or written.");
  app.describe_exit(kIncomplete,
                    "None fails, but for some it cannot be told: messages are missing, or a robot "
                    "was never heard.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto sentence = contradiction(options); !sentence.empty()) return app.refuse(sentence);
  return run(options);
}
