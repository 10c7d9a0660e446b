// SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>

#include <iostream>

#include "core/broken_pipe.h"
#include "core/clock.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
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
      {{"version", GALILEAN_VERSION},
       {"started", monitor::iso_time(static_cast<std::uint64_t>(wire::wall_clock_ns()))}}});
}

Result<void> end(mcap::Writer& writer, mcap::FileSink& file) {
  if (auto done = writer.end(); !done) return done;
  return file.sync();
}

void tell(const Options& options, const mcap::Writer& writer, std::size_t topics) {
  const auto& statistics = writer.statistics();
  if (statistics.messages == 0)
    std::cerr
        << "galilean-record: no robot sent anything; check that robots run, and in the same DDS "
           "domain (--domain or ROS_DOMAIN_ID)\n";
  std::printf("%s: %s of %s in %.1f s, %.1f MB\n", options.out.c_str(),
              plural(statistics.messages, "message").c_str(), plural(topics, "topic").c_str(),
              static_cast<double>(statistics.end_ns - statistics.start_ns) * 1e-9,
              static_cast<double>(writer.bytes_written()) * 1e-6);
}

Recorder::Selection selection(const Options& options) {
  Recorder::Selection selection;
  selection.images = !options.no_images;
  if (!options.topics.empty()) selection.topics.emplace(options.topics, std::regex::optimize);
  return selection;
}

int run(const Options& options) try {
  ignore_broken_pipes();
  Termination termination;
  auto chosen = selection(options);
  const auto participant = wire::Participant::join("record", options.domain);
  if (!participant) return fail(participant.error().message);
  auto file = mcap::FileSink::create(options.out, options.replace);
  if (!file) return fail(file.error().message);

  mcap::Writer writer(file.value(), {.library = "galilean " GALILEAN_VERSION});
  auto done = begin(writer);
  Recorder recorder(
      *participant.value(), writer, std::move(chosen),
      [](const std::string& problem) { std::cerr << "galilean-record: " << problem << '\n'; });
  if (done) done = record(recorder, termination, options.duration_s);
  if (done) done = end(writer, file.value());
  if (!done) return fail(done.error().message + "; what was recorded until then can still be read");
  tell(options, writer, recorder.topics());
  return 0;
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
  app.option("--out", options.out, "File to write, such as run.mcap")
      .required()
      .names_file(".mcap");
  app.option("--duration", options.duration_s,
             "How many seconds to record; without it until Ctrl-C")
      .positive();
  app.option("--topics", options.topics,
             "Record only topics whose names match this regular expression somewhere, such as "
             "'^/io/|score'");
  add_domain_option(app, options.domain);
  app.flag("--no-images", options.no_images, "Leave the cameras' pictures out");
  app.flag("--replace", options.replace, "Overwrite the file if it exists");
  if (const auto code = app.parse(argc, argv)) return *code;
  return run(options);
}
