// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/coverage/coverage.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/logs/coverage/program_coverage.h"
#include "monitor/logs/reading/selection.h"
#include "monitor/record/damage_text.h"
#include "monitor/replay/tracks.h"

namespace galilean::logs {
namespace {

constexpr const char* kCoverage = "galilean log coverage";
constexpr std::size_t kMostPrograms = 1000;

int fail_coverage(const std::string& sentence) {
  std::cerr << kCoverage << ": " << sentence << '\n';
  return kFailed;
}

/// What was done of all programs, by their hashes.
class Coverage {
 public:
  /// Errors: the file cannot be read.
  Result<void> read(const std::string& file) {
    const auto recording = Recording::open(file);
    if (!recording) return recording.error();
    const auto tracks = monitor::tracks_of(recording.value().summary());
    auto messages = SelectedMessages::of(recording.value(), {});
    if (!messages) return messages.error();
    while (const mcap::Message* message = messages.value().next()) {
      const auto track = tracks.played.find(message->channel_id);
      if (track != tracks.played.end()) take(track->second.ros_type, message->data);
    }
    code_ = std::max(code_, tell_damage(kCoverage, messages.value()));
    for (const auto& topic : tracks.foreign)
      if (topic.ends_with("/state") || topic.ends_with("/transition") ||
          topic.ends_with("/program"))
        tell("what is on " + visible(topic) + " is not counted: its type is of another release");
    return {};
  }

  [[nodiscard]] const std::map<std::string, ProgramCoverage>& programs() const { return programs_; }
  /// Returns kIncomplete if a part of the recordings could not be counted, else 0.
  [[nodiscard]] int code() const {
    if (undecoded_ == 0) return code_;
    std::cerr << kCoverage << ": " << undecoded_ << " messages are not whole\n";
    return kIncomplete;
  }

 private:
  void take(const std::string& type, mcap::ByteView cdr) {
    if (type == msg::Program::kRosType)
      decode<msg::Program>(cdr, [&](const auto& program) {
        if (auto* coverage = of(program.hash)) coverage->describe(program);
      });
    else if (type == msg::RobotState::kRosType)
      decode<msg::RobotState>(cdr, [&](const auto& state) {
        if (auto* coverage = of(state.program_hash)) coverage->note(state);
      });
    else if (type == msg::Transition::kRosType)
      decode<msg::Transition>(cdr, [&](const auto& transition) {
        if (auto* coverage = of(transition.program_hash)) coverage->note(transition);
      });
  }

  template <class Message, class Take>
  void decode(mcap::ByteView cdr, const Take& take_it) {
    Message message;
    if (msg::decode_cdr(cdr, message))
      take_it(message);
    else
      ++undecoded_;
  }

  /// Returns nullptr for a robot that runs no program, and if there are too many.
  ProgramCoverage* of(const std::string& hash) {
    if (hash.empty()) return nullptr;
    if (const auto known = programs_.find(hash); known != programs_.end()) return &known->second;
    if (programs_.size() == kMostPrograms) {
      tell("programs beyond the first " + std::to_string(kMostPrograms) + " are not counted");
      return nullptr;
    }
    return &programs_[hash];
  }

  void tell(const std::string& sentence) {
    code_ = kIncomplete;
    if (told_.insert(sentence).second) std::cerr << kCoverage << ": " << sentence << '\n';
  }

  std::map<std::string, ProgramCoverage> programs_;
  std::set<std::string> told_;
  std::uint64_t undecoded_ = 0;
  int code_ = 0;
};

void print_programs(const Coverage& coverage, const std::string& format) {
  auto json = monitor::MessageTree::object();
  for (const auto& [hash, program] : coverage.programs())
    if (format == "json")
      json[hash] = program.figures();
    else
      std::cout << (format == "dot" ? program.dot() : program.text());
  if (format == "json") std::cout << ordered_json_text(json, 2) << '\n';
}

/// Says which programs fall short of the share. Returns whether all reach it.
bool reach(const Coverage& coverage, double least_percent) {
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
  Coverage coverage;
  for (const auto& file : options.files)
    if (const auto done = coverage.read(file); !done) return fail_coverage(done.error().message);
  if (coverage.programs().empty())
    return fail_coverage("no robot of these recordings runs a program");
  print_programs(coverage, options.format);
  if (!std::cout.flush()) return kFailed;
  const int code = coverage.code();
  const bool reached = !options.least_percent || reach(coverage, *options.least_percent);
  return reached ? code : kFailed;
}

}  // namespace galilean::logs
