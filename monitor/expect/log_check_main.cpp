// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

#include "bhdl/source/source_provider.h"
#include "core/command_line/command_line.h"
#include "core/json_text.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"
#include "monitor/expect/recording/play_samples.h"
#include "monitor/expect/report/report.h"

namespace {

using namespace galilean;
using namespace galilean::expect;

constexpr int kCannotTell = 3;

struct Options {
  std::string recording;
  std::vector<std::string> expectations;
  std::string format = "text";
  std::string junit;
  double silence_s = 2;
};

int fail(const std::string& sentence) {
  std::cerr << "galilean-log-check: " << sentence << '\n';
  return kFailed;
}

/// Reads a file. That it cannot be read is a diagnostic, too.
Parsed parse_file(const std::string& path) {
  const auto text = bhdl::DiskSources({}).read(path, kMostBytes);
  if (text) return parse(path, text.value());
  const bool large = text.error().code == "file/too-large";
  Parsed parsed;
  parsed.diagnostics.push_back(
      {.file = path,
       .code = text.error().code,
       .message = large ? "the file is too large; expectations have at most " +
                              std::to_string(kMostBytes) + " bytes"
                        : text.error().message});
  return parsed;
}

Parsed parse_all(const std::vector<std::string>& paths) {
  Parsed all;
  for (const auto& path : paths) {
    auto parsed = parse_file(path);
    std::ranges::move(parsed.expectations, std::back_inserter(all.expectations));
    std::ranges::move(parsed.diagnostics, std::back_inserter(all.diagnostics));
  }
  return all;
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
  return judgement.count(Outcome::kCannotTell) > 0 ? kCannotTell : 0;
}

int judge(const Options& options, const Parsed& parsed) {
  const auto file = mcap::FileSource::open(options.recording);
  if (!file) return fail(file.error().message);
  const auto summary = mcap::summarize(file.value());
  if (!summary) return fail(options.recording + " " + summary.error().message);
  Judge judge(parsed.expectations, {.silence = from_seconds(options.silence_s)});
  auto played = play_samples(file.value(), summary.value(), judge);
  auto judgement = judge.finish(played.begin_ns, played.end_ns);
  std::ranges::move(played.notes, std::back_inserter(judgement.notes));
  const Report report{options.recording, judgement};
  std::cout << in_format(options.format, report);
  if (!options.junit.empty())
    if (auto done = write_file(options.junit, junit_report(report)); !done)
      return fail(done.error().message);
  return std::cout.flush() ? exit_code(judgement) : kFailed;
}

int run(const Options& options) try {
  const auto parsed = parse_all(options.expectations);
  if (!parsed.ok()) return print(parsed.diagnostics, options), kFailed;
  return judge(options, parsed);
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Judges a recording of the team by expectations, for people and for CI.",
                  "galilean log check");
  app.option("file", options.recording, "An MCAP file").required().names_file(".mcap");
  app.option("--expect", options.expectations, "Files of expectations, as docs/EXPECT.md says")
      .required()
      .names_file(".expect");
  app.option("--format", options.format, "What to print")
      .one_of({"text", "junit", "tap", "json", "github"})
      .show_default();
  app.option("--junit", options.junit, "Also write the report as JUnit's XML to this file")
      .names_file(".xml");
  app.option("--silence", options.silence_s,
             "After how many seconds without a message a robot's state and variables are unknown")
      .between(0.001, 1e6)
      .show_default();
  app.describe_exit(kFailed,
                    "An expectation does not hold, or a file could not be read or written.");
  app.describe_exit(kCannotTell,
                    "None fails, but for some the recording does not tell: messages "
                    "are missing, or a robot was never heard.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (std::isnan(options.silence_s)) return app.refuse("--silence nan is no number of seconds");
  return run(options);
}
