// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

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
#include "core/wire/ros_time.h"
#include "monitor/record/recorder.h"
#include "monitor/record/times.h"

namespace {

using namespace galilean;
using monitor::Recorder;

struct Options {
  std::string out;
  double duration_s = 0;  // 0: records until termination is asked for
  std::string topics;
  std::string schema = "ros2msg";
  int domain = -1;
  bool no_images = false;
  bool replace = false;
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

Result<void> begin(mcap::Writer& writer) {
  if (auto done = writer.begin(); !done) return done;
  return writer.write(mcap::Metadata{
      "galilean",
      {{"version", GALILEAN_VERSION}, {"started", monitor::iso_time(wire::wall_clock_ns())}}});
}

Result<void> end(mcap::Writer& writer, mcap::FileSink& file) {
  if (auto done = writer.end(); !done) return done;
  return file.sync();
}

/// Standard output, or standard error where that holds the recording itself.
std::FILE* summary_stream(const Options& options) {
  std::error_code unknown;
  const bool is_recording = std::filesystem::equivalent(options.out, "/dev/stdout", unknown);
  return is_recording ? stderr : stdout;
}

std::string why_empty(const Recorder& recorder) {
  if (recorder.topics() == 0 && recorder.left_out_topics())
    return "nothing was recorded, because no topic on the wire matches --topics, or all that do "
           "carry pictures (--no-images); 'galilean list' shows the topics";
  return "no robot sent anything; check that robots run, and in the same DDS domain (--domain or "
         "ROS_DOMAIN_ID)";
}

void tell(const Options& options, const mcap::Writer& writer, const Recorder& recorder) {
  const auto& statistics = writer.statistics();
  if (statistics.messages == 0) std::cerr << "galilean-record: " << why_empty(recorder) << '\n';
  std::fprintf(summary_stream(options), "%s: %s of %s in %.1f s, %.1f MB\n", options.out.c_str(),
               plural(statistics.messages, "message").c_str(),
               plural(recorder.topics(), "topic").c_str(),
               static_cast<double>(statistics.end_ns - statistics.start_ns) * 1e-9,
               static_cast<double>(writer.bytes_written()) * 1e-6);
}

/// Says what did not come. Returns the exit code.
int tell_losses(const std::vector<monitor::WriterLosses>& losses) {
  for (const auto& each : losses)
    if (each.lost.value_or(0) > 0)
      std::cerr << "galilean-record: " << each.topic << " lost " << *each.lost << " of "
                << plural(each.recorded + *each.lost, "message") << " of " << each.process << '\n';
  return monitor::total_lost(losses) > 0 ? kIncomplete : 0;
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
  auto file = mcap::FileSink::create(options.out, options.replace);
  if (!file) return fail(file.error().message);

  mcap::Writer writer(file.value(), {.library = "galilean " GALILEAN_VERSION});
  auto done = begin(writer);
  Recorder recorder(
      {.participant = *participant.value(),
       .writer = writer,
       .selection = std::move(chosen),
       .warn = [](const std::string& what) { std::cerr << "galilean-record: " << what << '\n'; },
       .ended = [&] { return termination.asked(); }});
  if (done) done = record(recorder, termination, options.duration_s);
  if (done) done = recorder.conclude();
  if (done) done = end(writer, file.value());
  if (!done) return fail(done.error().message + "; what was recorded until then can still be read");
  tell(options, writer, recorder);
  return tell_losses(recorder.losses());
} catch (const std::regex_error& error) {
  return fail("--topics '" + options.topics +
              "' is not a valid regular expression: " + error.what());
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Records every topic of the team as MCAP, to be opened by Foxglove or ROS 2.",
                  "galilean record");
  app.option("--out", options.out, "File to write, such as run.mcap, or '-' for standard output")
      .required()
      .names_file(".mcap");
  app.option("--duration", options.duration_s,
             "How many seconds to record; without it until Ctrl-C")
      .positive();
  app.option("--topics", options.topics,
             "Record only topics whose names match this regular expression somewhere, such as "
             "'^/io/|score'");
  app.option(
         "--schema", options.schema,
         "How the recording defines its messages: as .msg files do, which PlotJuggler and ROS 2 "
         "read, or in IDL")
      .one_of({"ros2msg", "ros2idl"})
      .show_default();
  add_domain_option(app, options.domain);
  app.flag("--no-images", options.no_images, "Leave the cameras' pictures out");
  app.flag("--replace", options.replace, "Overwrite the file if it exists");
  app.describe_exit(kIncomplete, "It is recorded, and messages were lost: which were was said.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (options.out == "-") {
    options.out = "/dev/stdout";
    options.replace = true;
  }
  return run(options);
}
