// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/plural.h"
#include "core/termination.h"
#include "monitor/record/recorder.h"
#include "monitor/record/size_text.h"

namespace {

using namespace galilean;
using monitor::Recorder;

struct Options {
  monitor::FilePlan plan{.library = "galilean " GALILEAN_VERSION};
  std::uint64_t min_free_bytes = 500'000'000;
  double split_duration_s = 0;  // 0: no file ends because it is long
  double duration_s = 0;  // 0: records until termination is asked for
  std::string topics;
  std::string schema = "ros2msg";
  int most_files = 0;
  int domain = -1;
  bool no_images = false;
};

int fail(const std::string& sentence) {
  std::cerr << "galilean-record: " << sentence << '\n';
  return 1;
}

/// Records for `duration_s` seconds, or without end if that is 0, until termination is asked for.
/// Errors: the recording ended sooner, because it could not be written.
Result<void> record(Recorder& recorder, Termination& termination, double duration_s) {
  constexpr int kLookAtClockEach_ms = 100;
  const SteadyClock clock;
  while (!termination.asked() &&
         (duration_s == 0 || to_seconds(clock.now() - Time{}) < duration_s)) {
    pollfd events[] = {{recorder.descriptor(), POLLIN, 0}, {termination.descriptor(), POLLIN, 0}};
    poll(events, 2, kLookAtClockEach_ms);
    if (auto done = recorder.pump(); !done) return done;
  }
  return {};
}

/// Who records, and where.
mcap::Text about(const Options& options) {
  char host[256] = "";
  static_cast<void>(gethostname(host, sizeof host - 1));
  return {{"version", GALILEAN_VERSION},
          {"host", host},
          {"domain", options.domain < 0 ? "as ROS_DOMAIN_ID says" : std::to_string(options.domain)}};
}

/// Standard output, or standard error where that holds the recording itself.
std::FILE* summary_stream(const Options& options) {
  std::error_code unknown;
  const bool is_recording = std::filesystem::equivalent(options.plan.out, "/dev/stdout", unknown);
  return is_recording ? stderr : stdout;
}

std::string why_empty(const Recorder& recorder) {
  if (recorder.topics() == 0 && recorder.left_out_topics())
    return "nothing was recorded, because no topic on the wire matches --topics, or all that do "
           "carry pictures (--no-images); 'galilean list' shows the topics";
  return "no robot sent anything; check that robots run, and in the same DDS domain (--domain or "
         "ROS_DOMAIN_ID)";
}

void tell(const Options& options, const monitor::RecordingFiles& files, const Recorder& recorder) {
  const auto totals = files.totals();
  if (totals.messages == 0) std::cerr << "galilean-record: " << why_empty(recorder) << '\n';
  std::fprintf(summary_stream(options), "%s: %s of %s in %.1f s, %.1f MB\n", files.name().c_str(),
               plural(totals.messages, "message").c_str(),
               plural(recorder.topics(), "topic").c_str(),
               static_cast<double>(totals.end_ns - totals.start_ns) * 1e-9,
               static_cast<double>(totals.bytes) * 1e-6);
}

/// Says what did not come. Returns the exit code.
int tell_losses(const std::vector<monitor::WriterLosses>& losses) {
  for (const auto& each : losses) {
    const auto lost = each.lost.value_or(0);
    const auto sent = each.recorded + lost + each.unwritten;
    const std::string of = " of " + plural(sent, "message") + " of " + each.process + '\n';
    if (lost > 0) std::cerr << "galilean-record: " << each.topic << " lost " << lost << of;
    if (each.unwritten > 0)
      std::cerr << "galilean-record: " << each.topic << " lacks, for want of room on the disk, "
                << each.unwritten << of;
  }
  return monitor::total_missing(losses) > 0 ? kIncomplete : 0;
}

Recorder::Selection selection(const Options& options) {
  Recorder::Selection selection;
  selection.images = !options.no_images;
  if (options.schema == "ros2idl") selection.language = monitor::SchemaLanguage::kIdl;
  if (!options.topics.empty()) selection.topics.emplace(options.topics, std::regex::optimize);
  return selection;
}

int run(const Options& options) try {
  ignore_broken_pipes();
  std::signal(SIGXFSZ, SIG_IGN);  // beyond the limit of `ulimit -f` a write fails, and that is told
  Termination termination;
  auto chosen = selection(options);
  const auto participant = wire::Participant::join("record", options.domain);
  if (!participant) return fail(participant.error().message);
  monitor::RecordingFiles files(options.plan);
  Recorder recorder(
      {.participant = *participant.value(),
       .files = files,
       .room = {options.min_free_bytes, [&] { return monitor::free_bytes(options.plan.out); }},
       .about = about(options),
       .selection = std::move(chosen),
       .warn = [](const std::string& what) { std::cerr << "galilean-record: " << what << '\n'; },
       .ended = [&] { return termination.asked(); }});
  if (auto begun = recorder.begin(); !begun) return fail(begun.error().message);
  auto done = record(recorder, termination, options.duration_s);
  if (done) done = recorder.conclude();
  if (!done) return fail(done.error().message + "; what was recorded until then can still be read");
  tell(options, files, recorder);
  return tell_losses(recorder.losses());
} catch (const std::regex_error& error) {
  return fail("--topics '" + options.topics +
              "' is not a valid regular expression: " + error.what());
} catch (const std::exception& error) {
  return fail(error.what());
}

/// Returns what reads an option into `target`, which must live until the options are read.
CommandLine::Reader size_into(std::uint64_t& target) {
  return [&target](const std::string& text) -> Result<void> {
    const auto bytes = monitor::bytes_of(text);
    if (!bytes) return bytes.error();
    target = bytes.value();
    return {};
  };
}

void complete(Options& options) {
  options.plan.split_span = from_seconds(options.split_duration_s);
  options.plan.most_files = static_cast<std::size_t>(options.most_files);
  if (options.plan.out != "-") return;
  options.plan.out = "/dev/stdout";
  options.plan.replace = true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Records every topic of the team as MCAP, to be opened by Foxglove or ROS 2.",
                  "galilean record");
  app.option("--out", options.plan.out,
             "File to write, such as run.mcap, or '-' for standard output")
      .required()
      .names_file(".mcap");
  app.option("--duration", options.duration_s,
             "How many seconds to record; without it until Ctrl-C")
      .positive();
  app.option("--topics", options.topics,
             "Record only topics whose names match this regular expression somewhere, such as "
             "'^/io/|score'");
  app.option("--schema", options.schema,
             "How the recording defines its messages: as .msg files do, which PlotJuggler and ROS 2 "
             "read, or in IDL")
      .one_of({"ros2msg", "ros2idl"})
      .show_default();
  app.option("--split-size", size_into(options.plan.split_bytes),
             "Go on in another file, run_1.mcap, whenever one has this size, such as 500MB");
  app.option("--split-duration", options.split_duration_s,
             "Go on in another file whenever one is so many seconds long")
      .positive();
  app.option("--max-files", options.most_files, "Delete the oldest file when there are more")
      .positive();
  app.option("--min-free", size_into(options.min_free_bytes),
             "Stand still while less than this is free on the disk, and go on when there is room; "
             "0: never")
      .describe_default("500MB");
  add_domain_option(app, options.domain);
  app.flag("--no-images", options.no_images, "Leave the cameras' pictures out");
  app.flag("--replace", options.plan.replace, "Overwrite files that exist");
  app.describe_exit(kIncomplete, "It is recorded, and messages are missing: which was said.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (options.most_files > 0 && options.plan.split_bytes == 0 && options.split_duration_s == 0)
    return app.refuse("--max-files needs --split-size or --split-duration");
  complete(options);
  return run(options);
}
