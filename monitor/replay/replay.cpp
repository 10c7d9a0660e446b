// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/replay.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <utility>

#include "core/command_line/exit_code.h"
#include "core/plural.h"
#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/log_info.h"
#include "monitor/replay/neighbours.h"
#include "monitor/replay/report.h"

namespace galilean::monitor {
namespace {

/// The time for DDS' discovery in both directions.
constexpr auto kAcquaintance = std::chrono::milliseconds(800);
constexpr auto kLookEach = std::chrono::milliseconds(500);
/// Thirty years, which a Duration can hold.
constexpr double kLongest_s = 1e9;

}  // namespace

std::string seconds_text(double duration_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << duration_s << " s";
  return text.str();
}

int fail_replay(const std::string& sentence) {
  std::cerr << "galilean-replay: " << sentence << '\n';
  return 1;
}

Replay::Replay(const ReplayOptions& options, const mcap::ByteSource& recording,
               const mcap::Summary& summary, Tracks tracks, Termination& termination)
    : options_(options),
      recording_(recording),
      summary_(summary),
      tracks_(std::move(tracks)),
      playback_(clock_, termination, options.rate) {}

int Replay::run() {
  auto joined = wire::Participant::join(wire::kReplayName, options_.domain);
  if (!joined) return fail_replay(joined.error().message);
  participant_ = std::move(joined).value();
  if (!may_begin()) return 1;
  if (playback_.has_keys())
    std::cout << "keys: space pauses, . steps, + and - change the rate, arrows go 10 s on and "
                 "back, Home to the start, q ends\n"
              << std::flush;
  begin();
  while (pass() && options_.loop) {
  }
  return damaged_ || summary_.recovered() || !copy_losses(summary_).empty() ? kIncomplete : 0;
}

/// Looks who is in the domain, and says it. Returns false if the replay must not begin.
bool Replay::may_begin() {
  others_ = std::make_unique<wire::Endpoints>(*participant_);
  if (!playback_.rest(clock_.now() + kAcquaintance)) return false;
  const auto there = others_->known();
  const auto same = namesakes(there, tracks_.played);
  if (!options_.anyway) {
    if (!clock_is_free(there)) return false;
    if (!same.empty()) return (void)fail_replay(why_not_beside(same)), false;
  }
  known_namesakes_.insert(same.live.begin(), same.live.end());
  say_what_comes(there);
  return true;
}

bool Replay::clock_is_free(const std::vector<wire::EndpointInfo>& there) const {
  const bool is_told = std::ranges::any_of(there, [](const auto& endpoint) {
    return endpoint.writes && endpoint.topic == wire::kClockTopic;
  });
  if (!options_.clock_hz || !is_told) return true;
  (void)fail_replay(
      "another process tells the time on /clock in this DDS domain already; end it, leave out "
      "--clock, or play all the same with --anyway");
  return false;
}

void Replay::say_what_comes(const std::vector<wire::EndpointInfo>& there) const {
  std::cout << before_playing(options_.file, summary_, tracks_)
            << who_is_where(robots_of(tracks_of(summary_)), robots_of(tracks_),
                            wire::robots_in(there))
            << std::flush;
}

/// Looks for monitors and for live robots, and tells the time, as long as the replay runs.
void Replay::begin() {
  playback_.every(kLookEach, [this] {
    if (stage_) stage_->look();
    warn_of_newcomers();
  });
  if (!options_.clock_hz) return;
  recorded_clock_ = std::make_unique<ClockWriter>(*participant_, wire::kClockTopic);
  playback_.every(from_seconds(1 / *options_.clock_hz), [this] { tell_clock(); });
}

/// A robot that comes to life later is nothing that the replay was asked about.
void Replay::warn_of_newcomers() {
  for (const auto& name : namesakes(others_->known(), tracks_.played).live)
    if (known_namesakes_.insert(name).second)
      std::cerr << "galilean-replay: " << visible(name)
                << " has come to life in this DDS domain, and sends under one name with the "
                   "recording now; end one of them\n";
}

/// Between two passes the time stands still.
void Replay::tell_clock() {
  if (!recorded_clock_) return;
  const auto now_ns = player_ ? player_->log_now_ns() : std::nullopt;
  told_ns_ = now_ns.value_or(told_ns_);
  if (told_ns_ == 0) return;
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
  const auto since_epoch_ns = static_cast<std::int64_t>(std::min(told_ns_, kMost));
  (void)recorded_clock_->write({wire::ros_time(since_epoch_ns)});  // the next one makes it good
}

/// Plays the recording once. Each pass has writers of its own, so that late joiners get nothing of
/// an earlier pass. Returns false if termination was asked for.
bool Replay::pass() {
  stage_ = std::make_unique<Stage>(*participant_, tracks_.played);
  if (!playback_.rest(clock_.now() + kAcquaintance)) return false;
  const Time began = clock_.now();
  Played played{.from = from_seconds(options_.from_s)};
  do {
    play(played);
  } while (played.goes_on);
  std::cout << "played " << plural(played.messages, "message") << " in "
            << seconds_text(to_seconds(clock_.now() - began)) << std::endl;
  tell_damage(played.damages, played.silences);
  if (stage_->lost() > 0)
    std::cerr << "galilean-replay: could not send " << plural(stage_->lost(), "message")
              << "; a message is left out if it is damaged or DDS does not take it in time\n";
  stage_.reset();
  return played.to_its_end;
}

/// Plays from one place to the end, or until it has to go on at another place.
void Replay::play(Played& played) {
  played.to_its_end = true;
  bool is_first = true;
  Player player(
      tracks_.played, pace(played.from), playback_.clock(),
      [&](std::uint16_t channel, mcap::ByteView cdr) { stage_->send(channel, cdr); },
      [&](Time due) {
        if (std::exchange(is_first, false)) tell_clock();
        played.to_its_end = playback_.until(due, player.position());
        return played.to_its_end;
      });
  player_ = &player;
  for (auto& damage : player.play(recording_, summary_.blocks))
    if (std::ranges::find(played.damages, damage.offset, &mcap::Damage::offset) ==
        played.damages.end())
      played.damages.push_back(std::move(damage));
  tell_clock();
  player_ = nullptr;
  played.messages += player.sent();
  played.silences = player.silences();
  const auto target = playback_.take_target();
  played.goes_on = target.has_value();
  if (target) played.from = std::min(*target, from_seconds(duration_s(summary_)));
}

Pace Replay::pace(Duration from) const {
  Pace pace{1, from};  // the clock of the replay has the rate
  if (options_.until_s) pace.until = from_seconds(std::min(*options_.until_s, kLongest_s));
  return pace;
}

/// Says what the replay left out, as far as it was not said before it began.
void Replay::tell_damage(const std::vector<mcap::Damage>& damages,
                         const std::vector<mcap::TimeRange>& silences) {
  if (std::exchange(told_damage_, true)) return;
  for (const auto& damage : newly_met(damages, summary_))
    std::cerr << "galilean-replay: left out: " << damage_text(damage, summary_) << '\n';
  if (!summary_.checked)
    for (const auto& silence : silences)
      std::cerr << "galilean-replay: " << silence_text(silence) << '\n';
  damaged_ = !damages.empty();
  if (const auto loss = loss_text(summary_); !loss.empty())
    std::cerr << "galilean-replay: " << options_.file << ": " << loss << '\n';
}

}  // namespace galilean::monitor
