// SPDX-License-Identifier: BSD-3-Clause
#include <exception>

#include "core/broken_pipe.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/termination.h"
#include "monitor/record/log_info.h"
#include "monitor/replay/choice.h"
#include "monitor/replay/playback.h"
#include "monitor/replay/replay.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

constexpr double kLeastClock_hz = 0.1, kMostClock_hz = 1000;

int run(const ReplayOptions& options) try {
  ignore_broken_pipes();
  Termination termination;
  const auto file = mcap::FileSource::open(options.file);
  if (!file) return fail_replay(file.error().message);
  const auto summary = mcap::summarize(file.value());
  if (!summary) return fail_replay(options.file + " " + summary.error().message);
  auto tracks = tracks_of(summary.value());
  if (options.clock_hz) leave_out_clock(tracks);
  if (tracks.played.empty()) return fail_replay(options.file + " has no topic that can be played");
  if (const auto chosen = choose(options.choice, tracks); !chosen)
    return fail_replay(options.file + ": " + chosen.error().message);
  if (options.from_s > duration_s(summary.value()))
    return fail_replay("--from " + seconds_text(options.from_s) + " is behind the end of " +
                       options.file + ", which lasts " + seconds_text(duration_s(summary.value())));
  return Replay(options, file.value(), summary.value(), std::move(tracks), termination).run();
} catch (const std::exception& error) {
  return fail_replay(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  ReplayOptions options;
  CommandLine app("Plays a recording of a team again, for the monitor, top, Foxglove or rviz2.",
                  "galilean replay");
  app.option("file", options.file, "An MCAP file that galilean record made")
      .required()
      .names_file(".mcap");
  app.option("--rate", options.rate, "Speed of the replay: 2 is twice as fast as recorded")
      .between(Playback::kLeastRate, Playback::kMostRate);
  app.option("--from", options.from_s, "Where to begin, in seconds from the start of the recording")
      .not_negative();
  app.option("--until", options.until_s, "Where to end, in seconds from the start of the recording")
      .positive();
  app.option("--robots", options.choice.robots,
             "Play only these robots, such as io,ganymede, beside others that are live; the score, "
             "the map and simulations of the recording are left out")
      .divided_by(',')
      .not_empty();
  app.option("--topic", options.choice.topics, "Play only these topics, such as io/state")
      .not_empty();
  app.options(
      "--remap",
      [&options](const std::string& text) -> Result<void> {
        auto renamed = read_renamed(text);
        if (!renamed) return renamed.error();
        options.choice.renamed.push_back(std::move(renamed).value());
        return {};
      },
      "Play a topic under another name: /io/state:=/europa/state");
  app.option("--clock", options.clock_hz,
             "Tell the recording's time on /clock so many times a second, for ROS 2's nodes with "
             "use_sim_time; without it, /clock is not written")
      .between(kLeastClock_hz, kMostClock_hz)
      .for_example({"40"});
  app.flag("--loop", options.loop, "Begin again at the end, until Ctrl-C");
  app.flag("--anyway", options.anyway,
           "Play even if live robots in the domain have the same names");
  add_domain_option(app, options.domain);
  app.describe_exit(kIncomplete,
                    "A part of the recording is damaged or missing; the rest was played.");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (options.until_s && *options.until_s <= options.from_s)
    return app.refuse("--until must be behind --from");
  return run(options);
}
