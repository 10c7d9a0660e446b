// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/exit_code.h"
#include "core/termination.h"
#include "monitor/record/command/about.h"
#include "monitor/record/command/expression_trigger.h"
#include "monitor/record/command/recording_options.h"
#include "monitor/record/command/steering.h"
#include "monitor/record/recorder.h"
#include "monitor/record/recording_report.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

void say(const std::string& sentence) {
  std::cerr << "galilean-record: " << sentence << '\n';
}

int fail(const std::string& sentence) {
  say(sentence);
  return kFailed;
}

/// Records for `duration_s` seconds, or without end if that is 0, until termination is asked for or
/// a key ends it. Errors: the recording ended sooner, because it could not be written.
Result<void> record(Recorder& recorder, Steering& steering, Termination& termination,
                    const Clock& clock, double duration_s) {
  constexpr int kLookAtClockEach_ms = 100;
  const Time began = clock.now();
  while (!termination.asked() && !steering.ended() &&
         (duration_s == 0 || to_seconds(clock.now() - began) < duration_s)) {
    pollfd events[] = {{recorder.descriptor(), POLLIN, 0},
                       {termination.descriptor(), POLLIN, 0},
                       {steering.descriptor(), POLLIN, 0}};
    poll(events, 3, kLookAtClockEach_ms);
    if (auto done = recorder.pump(); !done) return done;
    if (auto done = steering.obey(); !done) return done;
  }
  return {};
}

/// Returns whether the recording goes where standard output goes.
bool is_standard_output(const std::string& out) {
  using FileStatus = struct stat;
  FileStatus file{}, standard{};
  return out == kStandardOutput ||
         (stat(out.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &standard) == 0 &&
          file.st_dev == standard.st_dev && file.st_ino == standard.st_ino);
}

/// Returns why the file for the first event cannot be made, which is better known before the event;
/// or an empty text.
std::string taken(const RecordingOptions& options) {
  std::error_code unknown;
  if (options.on.empty() || options.plan.replace) return {};
  if (!std::filesystem::exists(options.plan.out, unknown)) return {};
  return options.plan.out + " exists already; --replace overwrites it";
}

void say_why_empty(const TopicRecordings& recordings) {
  if (recordings.topics() > 0)
    say(emptiness_text(Emptiness::kAllSilent));
  else if (recordings.left_out_topics())
    say(emptiness_text(Emptiness::kAllLeftOut));
  else
    say(emptiness_text(Emptiness::kNobodyHeard));
}

/// Says what was recorded and what is missing. `on` is the event that was waited for, or empty.
/// Returns the exit code.
int report(const RecordingFiles& files, const TopicRecordings& recordings, const std::string& on) {
  if (!on.empty() && files.totals().files == 0) {
    say("nothing was recorded, because it never came true: " + on);
    return 0;
  }
  const auto losses = recordings.losses();
  const auto missing = total_missing(losses);
  if (files.totals().messages == 0 && missing == 0) say_why_empty(recordings);
  std::ostream& out = is_standard_output(files.plan().out) ? std::cerr : std::cout;
  out << recording_text(files.name(), files.totals(), recordings.topics()) << std::endl;
  for (const auto& sentence : missing_text(losses)) say(sentence);
  return missing > 0 ? kIncomplete : 0;
}

int run(RecordingOptions& options) try {
  ignore_broken_pipes();
  ignore_file_size_limit();
  Termination termination;
  const SteadyClock clock;
  const auto participant = wire::Participant::join("record", options.domain);
  if (!participant) return fail(participant.error().message);
  options.plan.library = "galilean " GALILEAN_VERSION;
  if (const auto there = taken(options); !there.empty()) return fail(there);
  Definitions definitions(*participant.value(), [&] { return termination.asked(); });
  std::unique_ptr<ExpressionTrigger> trigger;
  if (!options.on.empty()) {
    auto read = ExpressionTrigger::read(options.on, definitions);
    if (!read) return fail("--on: " + read.error().message);
    trigger = std::move(read).value();
    options.snapshots.trigger = trigger.get();
  }
  RecordingFiles files(options.plan);
  Recorder recorder({.participant = *participant.value(),
                     .clock = clock,
                     .files = files,
                     .room = {options.min_free_bytes, [&] { return free_bytes(options.plan.out); }},
                     .about = about(options, participant.value()->domain()),
                     .selection = std::move(options.selection),
                     .language = options.language,
                     .picture_bytes_per_s = options.picture_bytes_per_s,
                     .snapshots = options.snapshots,
                     .warn = say,
                     .ended = [&] { return termination.asked(); }});
  if (auto begun = recorder.begin(); !begun) return fail(begun.error().message);
  RecorderDesk desk(*participant.value(), options.name);
  Steering steering({recorder, files, desk, clock, host_name(), say});
  steering.greet();
  auto done = record(recorder, steering, termination, clock, options.duration_s);
  if (done) done = recorder.conclude();
  if (!done)
    return fail(done.error().message + (files.is_lost()
                                            ? "; what was recorded to it is lost"
                                            : "; what was recorded until then can still be read"));
  return report(files, recorder.recordings(), options.on);
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  RecordingOptions options;
  if (const auto code = read_options(argc, argv, options)) return *code;
  return run(options);
}
