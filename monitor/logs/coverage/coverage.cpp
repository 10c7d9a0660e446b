// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/coverage/coverage.h"

#include <algorithm>
#include <iostream>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/coverage/recorded_coverage.h"
#include "monitor/logs/reading/selection.h"

namespace galilean::logs {
namespace {

constexpr const char* kCoverage = "galilean log coverage";

int fail_coverage(const std::string& sentence) {
  std::cerr << kCoverage << ": " << sentence << '\n';
  return kFailed;
}

/// Counts a recording's messages. Returns kIncomplete if a part of it is damaged, else 0.
/// Errors: the file cannot be read.
Result<int> count(const std::string& file, monitor::RecordedCoverage& coverage) {
  const auto recording = Recording::open(file);
  if (!recording) return recording.error();
  auto messages = SelectedMessages::of(recording.value(), {});
  if (!messages) return messages.error();
  coverage.begin(recording.value().summary());
  while (const mcap::Message* message = messages.value().next()) coverage.take(*message);
  return tell_damage(kCoverage, messages.value());
}

/// Says what could not be counted. Returns kIncomplete if anything could not, else 0.
int tell_uncounted(const monitor::RecordedCoverage& coverage) {
  const auto sentences = coverage.uncounted();
  for (const auto& sentence : sentences) std::cerr << kCoverage << ": " << sentence << '\n';
  return sentences.empty() ? 0 : kIncomplete;
}

void print_programs(const monitor::RecordedCoverage& coverage, const std::string& format) {
  auto json = monitor::MessageTree::object();
  for (const auto& [hash, program] : coverage.programs())
    if (format == "json")
      json[hash] = program.figures();
    else
      std::cout << (format == "dot" ? program.dot() : program.text());
  if (format == "json") std::cout << ordered_json_text(json, 2) << '\n';
}

/// Says which programs fall short of the share. Returns whether all reach it.
bool reach(const monitor::RecordedCoverage& coverage, double least_percent) {
  bool all = true;
  for (const auto& [hash, program] : coverage.programs()) {
    const double percent = program.described() ? 100 * std::min(program.share_of_states(),
                                                                program.share_of_conditions())
                                               : 0;
    if (percent >= least_percent) continue;
    all = false;
    std::cerr << kCoverage << ": less than " << least_percent << " % of " << visible(program.name())
              << " was exercised\n";
  }
  return all;
}

}  // namespace

int print_coverage(const CoverageOptions& options) {
  monitor::RecordedCoverage coverage;
  int code = 0;
  for (const auto& file : options.files) {
    const auto counted = count(file, coverage);
    if (!counted) return fail_coverage(counted.error().message);
    code = std::max(code, counted.value());
  }
  code = std::max(code, tell_uncounted(coverage));
  if (coverage.programs().empty())
    return fail_coverage("no robot of these recordings runs a program");
  print_programs(coverage, options.format);
  if (!std::cout.flush()) return kFailed;
  const bool reached = !options.least_percent || reach(coverage, *options.least_percent);
  return reached ? code : kFailed;
}

}  // namespace galilean::logs
