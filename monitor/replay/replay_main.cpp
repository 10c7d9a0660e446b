// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>

#include "core/broken_pipe.h"
#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/plural.h"
#include "core/termination.h"
#include "core/wire/discovery.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/log_info.h"
#include "monitor/replay/choice.h"
#include "monitor/replay/playback.h"
#include "monitor/replay/player.h"
#include "monitor/replay/report.h"
#include "monitor/replay/stage.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;

/// The time for DDS' discovery in both directions.
constexpr auto kAcquaintance = std::chrono::milliseconds(800);
/// Thirty years, which a Duration can hold.
constexpr double kLongest_s = 1e9;

struct Options {
  std::string file;
  double rate = 1;
  double from_s = 0;
  std::optional<double> until_s;
  Choice choice;
  bool loop = false;
  bool anyway = false;
  int domain = -1;
};

/// Returns a text such as "5.9 s".
std::string seconds(double duration_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << duration_s << " s";
  return text.str();
}

int fail(const std::string& sentence) {
  std::cerr << "galilean-replay: " << sentence << '\n';
  return 1;
}

class Replay {
 public:
  Replay(const Options& options, const mcap::ByteSource& recording, const mcap::Summary& summary,
         Tracks tracks, Termination& termination)
      : options_(options),
        recording_(recording),
        summary_(summary),
        tracks_(std::move(tracks)),
        playback_(clock_, termination, options.rate) {}

  int run() {
    const auto joined = wire::Participant::join("replay", options_.domain);
    if (!joined) return fail(joined.error().message);
    auto& participant = *joined.value();
    if (!options_.anyway && !is_free(participant)) return 1;
    std::cout << before_playing(options_.file, summary_, tracks_) << std::flush;
    if (playback_.has_keys())
      std::cout << "keys: space pauses, . steps, + and - change the rate, arrows go 10 s on and "
                   "back, Home to the start, q ends\n"
                << std::flush;
    while (pass(participant) && options_.loop) {
    }
    return damaged_ || summary_.recovered() ? kIncomplete : 0;
  }

 private:
  /// What was played so far, and from where it goes on.
  struct Played {
    Duration from{};
    bool goes_on = false, to_its_end = true;
    std::uint64_t messages = 0;
    std::vector<mcap::Damage> damages = {};
    std::vector<mcap::TimeRange> silences = {};
  };

  bool is_free(wire::Participant& participant) {
    const wire::Discovery others(participant);
    if (!playback_.rest(clock_.now() + kAcquaintance)) return false;
    const auto names = live_namesakes(others.publications(), tracks_.played);
    if (names.empty()) return true;
    (void)fail(listed(names) + (names.size() == 1 ? " is" : " are") +
               " live in this DDS domain, and a live robot and the recording would send under one "
               "name; end the live "
               "ones, use another domain (--domain), or play all the same with --anyway");
    return false;
  }

  /// Plays the recording once. Each pass has writers of its own, so that late joiners get nothing
  /// of an earlier pass. Returns false if termination was asked for.
  bool pass(wire::Participant& participant) {
    Stage stage(participant, tracks_.played);
    if (!playback_.rest(clock_.now() + kAcquaintance)) return false;
    const Time began = clock_.now();
    Played played{.from = from_seconds(options_.from_s)};
    do {
      play(stage, played);
    } while (played.goes_on);
    std::cout << "played " << plural(played.messages, "message") << " in "
              << seconds(to_seconds(clock_.now() - began)) << std::endl;
    tell_damage(played.damages, played.silences);
    if (stage.lost() > 0)
      std::cerr << "galilean-replay: could not send " << plural(stage.lost(), "message")
                << "; a message is left out if it is damaged or DDS does not take it in time\n";
    return played.to_its_end;
  }

  /// Plays from one place to the end, or until it has to go on at another place.
  void play(Stage& stage, Played& played) {
    played.to_its_end = true;
    Player player(
        tracks_.played, pace(played.from), playback_.clock(),
        [&](std::uint16_t channel, mcap::ByteView cdr) { stage.send(channel, cdr); },
        [&](Time due) {
          played.to_its_end = playback_.until(due, player.position(), [&] { stage.look(); });
          return played.to_its_end;
        });
    for (auto& damage : player.play(recording_, summary_.blocks))
      if (std::ranges::find(played.damages, damage.offset, &mcap::Damage::offset) ==
          played.damages.end())
        played.damages.push_back(std::move(damage));
    played.messages += player.sent();
    played.silences = player.silences();
    const auto target = playback_.take_target();
    played.goes_on = target.has_value();
    if (target) played.from = std::min(*target, from_seconds(duration_s(summary_)));
  }

  [[nodiscard]] Pace pace(Duration from) const {
    Pace pace{1, from};  // the clock of the replay has the rate
    if (options_.until_s) pace.until = from_seconds(std::min(*options_.until_s, kLongest_s));
    return pace;
  }

  /// Says what the replay left out, as far as it was not said before it began.
  void tell_damage(const std::vector<mcap::Damage>& damages,
                   const std::vector<mcap::TimeRange>& silences) {
    if (std::exchange(told_, true)) return;
    for (const auto& damage : newly_met(damages, summary_))
      std::cerr << "galilean-replay: left out: " << damage_text(damage, summary_) << '\n';
    if (!summary_.checked)
      for (const auto& silence : silences)
        std::cerr << "galilean-replay: " << silence_text(silence) << '\n';
    damaged_ = !damages.empty();
    if (const auto loss = loss_text(summary_); !loss.empty())
      std::cerr << "galilean-replay: " << options_.file << ": " << loss << '\n';
  }

  const Options& options_;
  const mcap::ByteSource& recording_;
  const mcap::Summary& summary_;
  Tracks tracks_;
  SteadyClock clock_;
  Playback playback_;
  bool told_ = false;
  bool damaged_ = false;
};

int run(const Options& options) try {
  ignore_broken_pipes();
  Termination termination;
  const auto file = mcap::FileSource::open(options.file);
  if (!file) return fail(file.error().message);
  const auto summary = mcap::summarize(file.value());
  if (!summary) return fail(options.file + " " + summary.error().message);
  auto tracks = tracks_of(summary.value());
  if (tracks.played.empty()) return fail(options.file + " has no topic that can be played");
  if (const auto chosen = choose(options.choice, tracks); !chosen)
    return fail(options.file + ": " + chosen.error().message);
  if (options.from_s > duration_s(summary.value()))
    return fail("--from " + seconds(options.from_s) + " is behind the end of " + options.file +
                ", which lasts " + seconds(duration_s(summary.value())));
  return Replay(options, file.value(), summary.value(), std::move(tracks), termination).run();
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
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
  app.option("--topic", options.choice.topics, "Play only these topics, such as io/state");
  app.options(
      "--remap",
      [&options](const std::string& text) -> Result<void> {
        auto renamed = read_renamed(text);
        if (!renamed) return renamed.error();
        options.choice.renamed.push_back(std::move(renamed).value());
        return {};
      },
      "Play a topic under another name: /io/state:=/europa/state");
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
