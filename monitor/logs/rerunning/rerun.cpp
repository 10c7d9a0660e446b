// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/rerunning/rerun.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include "core/broken_pipe.h"
#include "core/command_line/exit_code.h"
#include "core/installation.h"
#include "core/visible_text.h"
#include "monitor/logs/reading/selection.h"
#include "monitor/logs/rerunning/recorded_inputs.h"
#include "monitor/logs/rerunning/run_process.h"
#include "monitor/record/channel_metadata.h"
#include "monitor/replay/tracks.h"

namespace galilean::logs {
namespace {

constexpr const char* kRerun = "galilean log rerun";
constexpr std::size_t kMostRobots = 64;  ///< each has a process of its own

int fail_rerun(const std::string& sentence) {
  std::cerr << kRerun << ": " << sentence << '\n';
  return kFailed;
}

/// The part of a writer's GUID, in hexadecimal digits, that names its process.
constexpr std::size_t kParticipantDigits = 24;

/// A wrong result counts more than one that cannot be told.
int worse(int a, int b) {
  if (a == kFailed || b == kFailed) return kFailed;
  return std::max(a, b);
}

std::string rerun_program() {
  return (program_folder() / "galilean-rerun").string();
}

/// The runs of all robots of a recording, each in a process. A robot that was started anew is
/// another run.
class Runs {
 public:
  explicit Runs(const RerunOptions& options) : options_(options) {}

  /// Errors: no process can be started.
  Result<void> read(const Recording& recording) {
    const auto& file = recording.path();
    const auto& summary = recording.summary();
    const auto tracks = monitor::tracks_of(summary);
    auto messages = SelectedMessages::of(recording, {});
    if (!messages) return messages.error();
    while (const mcap::Message* message = messages.value().next()) {
      const auto track = tracks.inputs.find(message->channel_id);
      if (track == tracks.inputs.end() || !is_wanted(track->second.topic)) continue;
      const auto run = run_of(file, summary.channels.at(track->first));
      if (!run) return run.error();
      run.value()->send(message->data);
    }
    code_ = worse(code_, tell_damage(kRerun, messages.value()));
    for (const auto& topic : tracks.foreign)
      if (topic.ends_with(kInputs) && is_wanted("rt" + topic)) tell_foreign(topic);
    return {};
  }

  /// Ends all runs. Returns the exit code.
  int finish() {
    for (auto& [writer, run] : runs_) {
      const auto code = run->finish();
      code_ = worse(code_, code ? code.value() : fail_rerun(code.error().message));
    }
    return code_;
  }
  [[nodiscard]] bool any() const noexcept { return !runs_.empty() || code_ == kIncomplete; }

 private:
  [[nodiscard]] bool is_wanted(const std::string& topic) const {
    return options_.robots.empty() || std::ranges::any_of(options_.robots, [&](const auto& robot) {
             return topic == "rt/" + robot + kInputs;
           });
  }

  /// All writers of a process are one run: a robot makes a new one when it is read again. The
  /// recording of another tool does not name them: then a channel is one.
  Result<RunProcess*> run_of(const std::string& file, const mcap::Channel& channel) {
    const auto named = channel.metadata.find(monitor::kChannelWriter);
    const std::string writer = named != channel.metadata.end()
                                   ? named->second.substr(0, kParticipantDigits)
                                   : file + " channel " + std::to_string(channel.id);
    auto& run = runs_[channel.topic + ' ' + writer];
    if (run) return run.get();
    if (runs_.size() > kMostRobots)
      return Error{"the recording has more than " + std::to_string(kMostRobots) +
                   " runs of robots: choose some with --robot, or a part with galilean log slice"};
    auto started = RunProcess::start(command(file, channel.topic));
    if (!started) return started.error();
    run = std::move(started).value();
    return run.get();
  }

  [[nodiscard]] std::vector<std::string> command(const std::string& file,
                                                 const std::string& topic) const {
    std::vector<std::string> words{rerun_program(), "--title", file + ' ' + topic};
    if (!options_.bhdl_file.empty()) words.insert(words.end(), {"--bhdl", options_.bhdl_file});
    if (options_.json) words.emplace_back("--json");
    return words;
  }

  void tell_foreign(const std::string& topic) {
    std::cerr << kRerun << ": " << visible(topic)
              << " is of another release, whose robots cannot be run again here\n";
    code_ = worse(code_, kIncomplete);
  }

  const RerunOptions& options_;
  std::map<std::string, std::unique_ptr<RunProcess>> runs_;  ///< by topic and process
  int code_ = 0;
};

/// Has what is wrong with the program, or suspect, told once and not by each run. Returns whether
/// it can be run. Errors: no process can be started.
Result<bool> check_program(const std::string& bhdl_file) {
  if (bhdl_file.empty()) return true;
  auto check = RunProcess::start({rerun_program(), "--check", "--bhdl", bhdl_file});
  if (!check) return check.error();
  const auto code = check.value()->finish();
  if (!code) return code.error();
  return code.value() == 0;
}

/// Errors: one cannot be read.
Result<Recordings> open_all(const std::vector<std::string>& files) {
  Recordings recordings;
  for (const auto& file : files) {
    auto recording = Recording::open(file);
    if (!recording) return recording.error();
    recordings.push_back(std::make_unique<Recording>(std::move(recording).value()));
  }
  return Result<Recordings>(std::move(recordings));
}

}  // namespace

int rerun_recordings(const RerunOptions& options) {
  ignore_broken_pipes();
  const auto recordings = open_all(options.files);
  if (!recordings) return fail_rerun(recordings.error().message);
  if (auto right = check_robots(options.robots, recordings.value()); !right)
    return fail_rerun(right.error().message);
  const auto is_right = check_program(options.bhdl_file);
  if (!is_right) return fail_rerun(is_right.error().message);
  if (!is_right.value()) return kFailed;
  Runs runs(options);
  for (const auto& recording : recordings.value())
    if (const auto done = runs.read(*recording); !done) return fail_rerun(done.error().message);
  if (!runs.any())
    return fail_rerun(
        "there is nothing to run again: no robot's inputs are recorded; 'galilean record --inputs "
        "--out FILE' records them, best from before the robots start");
  return runs.finish();
}

}  // namespace galilean::logs
