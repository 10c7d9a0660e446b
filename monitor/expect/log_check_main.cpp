// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "core/broken_pipe.h"
#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/progress_bar.h"
#include "core/written_files.h"
#include "monitor/expect/check_options.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/expectation_files.h"
#include "monitor/expect/live/live_samples.h"
#include "monitor/expect/problems/problems.h"
#include "monitor/expect/recording/play_samples.h"
#include "monitor/expect/report/report.h"

namespace {

using namespace galilean;
using namespace galilean::expect;

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

std::string about_what(const CheckOptions& options) {
  if (options.live) return "the live team";
  return options.recording.empty() ? "expectations" : options.recording;
}

/// Writes to the file of --junit that the run has not come to its end, so that no older report is
/// taken for that of a run that is killed. A pipe gets the report alone. Errors: it cannot be
/// written.
Result<void> begin_report(const CheckOptions& options) {
  std::error_code unknown;
  if (options.junit.empty() || std::filesystem::is_other(options.junit, unknown)) return {};
  return write_report(options.junit,
                      junit_problems(about_what(options),
                                     {{.message = "the run has not come to its end", .file = {}}}));
}

/// Prints why nothing was judged for programs, where they read, and writes it to the file of
/// --junit. Returns the exit code.
int tell_programs(const CheckOptions& options, const std::vector<Problem>& problems,
                  const std::vector<bhdl::Diagnostic>& mistakes) {
  const std::string about = about_what(options);
  if (options.format == "junit") std::cout << junit_problems(about, problems);
  if (options.format == "tap") std::cout << tap_problems(problems);
  if (options.format == "github") std::cout << github_problems(problems);
  if (options.format == "json") {
    nlohmann::json json{{"diagnostics", mistakes}};
    if (mistakes.empty() && !problems.empty()) json["error"] = problems.front().message;
    std::cout << json_text(json, 2) << '\n';
  }
  if (!options.junit.empty())
    if (auto done = write_report(options.junit, junit_problems(about, problems)); !done)
      return fail(done.error().message);
  return std::cout.flush() && problems.empty() ? 0 : kFailed;
}

std::vector<Problem> problems_of_run(const CheckOptions& options) {
  std::vector<Problem> problems;
  for (const auto& each : options.problems)
    problems.push_back({.message = each, .file = {}, .name = "the run"});
  for (const auto& each : options.shortages)
    problems.push_back({.message = each, .file = {}, .name = "the recording"});
  return problems;
}

/// Says why nothing could be judged, to people and to programs. Returns the exit code.
int give_up(const CheckOptions& options, const std::string& sentence) {
  (void)fail(sentence);
  auto problems = problems_of_run(options);
  problems.insert(problems.begin(), Problem{.message = sentence, .file = {}});
  return tell_programs(options, problems, {});
}

/// Tells the mistakes in the expectations, if there are any. Returns the exit code.
int tell_mistakes(const CheckOptions& options, const std::vector<bhdl::Diagnostic>& mistakes) {
  std::vector<Problem> problems;
  for (const auto& each : mistakes) {
    std::cerr << bhdl::format(each) << '\n';
    problems.push_back({each.message + (each.hint.empty() ? "" : "; " + each.hint), each.file,
                        each.line, each.column});
  }
  return tell_programs(options, problems, mistakes);
}

int exit_code(const Judgement& judgement, const CheckOptions& options) {
  if (judgement.count(Outcome::kFails) > 0 || !options.problems.empty()) return kFailed;
  const bool is_doubtful = judgement.count(Outcome::kCannotTell) > 0 || !options.shortages.empty();
  return is_doubtful ? kIncomplete : 0;
}

Result<Played> read_recording(const CheckOptions& options, Judge& judge) {
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

Result<Played> hear_team(const CheckOptions& options, Judge& judge) {
  const auto session = monitor::WireSession::join(options.domain, "check");
  if (!session) return session.error();
  return listen(*session.value(), judge, from_seconds(options.for_s.value_or(kLongest_s)));
}

int tell(const CheckOptions& options, const Judgement& judgement) {
  const Report report{options.live ? "the live team" : options.recording, judgement, options.live,
                      problems_of_run(options)};
  std::cout << in_format(options.format, report);
  if (!options.junit.empty())
    if (auto done = write_report(options.junit, junit_report(report)); !done)
      return fail(done.error().message);
  return std::cout.flush() ? exit_code(judgement, options) : kFailed;
}

/// Errors: the report is to be written over what is read.
Result<void> check_files(const CheckOptions& options) {
  auto read = options.expectations;
  read.push_back(options.recording);
  return check_written_files({options.junit}, read);
}

int run(const CheckOptions& options) try {
  if (const auto right = check_files(options); !right) return fail(right.error().message);
  const auto parsed = parse_files(options.expectations);
  if (!parsed.ok() || options.syntax) return tell_mistakes(options, parsed.diagnostics);
  if (const auto begun = begin_report(options); !begun) return fail(begun.error().message);
  Judge judge(parsed.expectations, {.silence = from_seconds(options.silence_s)});
  auto played = options.live ? hear_team(options, judge) : read_recording(options, judge);
  if (!played) return give_up(options, played.error().message);
  auto judgement = judge.finish(played.value().begin_ns, played.value().end_ns);
  judgement.silences = played.value().silences;
  std::ranges::copy(played.value().notes, std::back_inserter(judgement.notes));
  return tell(options, judgement);
} catch (const std::exception& error) {
  return give_up(options, error.what());
}

}  // namespace

int main(int argc, char** argv) {
  ignore_file_size_limit();
  CheckOptions options;
  if (const auto code = read_check_options(argc, argv, options)) return *code;
  return run(options);
}
