// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/recording_check.h"

#include <chrono>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>
#include <utility>

#include "core/installation.h"
#include "monitor/expect/problems/problems.h"
#include "monitor/front/process.h"
#include "monitor/front/siblings.h"

namespace galilean::front {
namespace {

constexpr auto kLookAtCheckEach = std::chrono::milliseconds(10);

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

RecordingCheck::RecordingCheck(const std::vector<std::string>& expectations, std::string junit,
                               std::filesystem::path logs, Termination& termination)
    : junit_(std::move(junit)), logs_(std::move(logs)), termination_(termination) {
  for (const auto& each : expectations)
    expectations_.push_back(find_file(each, "expectations", ".expect").string());
}

Result<void> RecordingCheck::begin() {
  return write_junit("the run has not come to its end");
}

Result<void> RecordingCheck::give_up(const std::string& why) {
  return has_told_ ? Result<void>() : write_junit(why);
}

Result<void> RecordingCheck::write_junit(const std::string& why) const {
  if (junit_.empty()) return {};
  return expect::write_report(
      junit_, expect::junit_problems("galilean demo", {{.message = why, .file = {}}}));
}

/// Expectations without mistakes leave the XML as it is: `log check` would write that all is well.
Result<void> RecordingCheck::read_expectations() {
  const auto said = run("expectations", {"--syntax"});
  if (!said) return said.error();
  if (said.value().code == 0) return {};
  if (!junit_.empty()) has_told_ = run("mistakes", {"--syntax", "--junit", junit_}).ok();
  return Error{"the expectations cannot be used:\n" + said.value().text};
}

Result<int> RecordingCheck::judge(const std::string& recording,
                                  const std::vector<std::string>& problems,
                                  const std::vector<std::string>& shortages) {
  std::vector<std::string> arguments{recording};
  if (!junit_.empty()) arguments.insert(arguments.end(), {"--junit", junit_});
  for (const auto& each : problems) arguments.insert(arguments.end(), {"--problem", each});
  for (const auto& each : shortages) arguments.insert(arguments.end(), {"--shortage", each});
  const auto said = run("check", std::move(arguments));
  if (!said) return said.error();
  has_told_ = true;
  std::cout << said.value().text << std::flush;
  return said.value().code;
}

Result<RecordingCheck::Said> RecordingCheck::run(const std::string& name,
                                                 std::vector<std::string> arguments) const {
  const auto program = sibling("galilean-log-check");
  if (!is_program(program)) return Error{program + " is not there; build it first"};
  arguments.insert(arguments.begin(), program);
  for (const auto& each : expectations_) arguments.insert(arguments.end(), {"--expect", each});
  auto process = Process::start(name, arguments, logs_ / (name + ".log"));
  if (!process) return process.error();
  while (process.value().running()) {
    if (termination_.asked()) return Error{"ended before the recording was judged"};
    std::this_thread::sleep_for(kLookAtCheckEach);
  }
  const auto code = process.value().exit_code();
  if (!code) return Error{program + " was " + process.value().ending()};
  return Said{*code, contents_of(process.value().log())};
}

}  // namespace galilean::front
