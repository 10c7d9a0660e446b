// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/seekable_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {
namespace {

constexpr std::uint64_t kStart_ns = 1'700'000'000'000'000'000;
constexpr std::uint16_t kState = 1, kTransition = 2, kSightings = 3, kCommand = 4, kStateAnew = 5;

const std::vector<RecordedTopic> kTopics{
    {.topic = "/io/state", .delivery = wire::Delivery::kState, .channels = {kState, kStateAnew}},
    {.topic = "/io/transition", .delivery = wire::Delivery::kEvent, .channels = {kTransition}},
    {.topic = "/io/sightings", .delivery = wire::Delivery::kStream, .channels = {kSightings}},
    {.topic = "/team/command", .delivery = wire::Delivery::kCommand, .channels = {kCommand}}};

constexpr std::uint64_t log_ns(double at_s) {
  return kStart_ns + static_cast<std::uint64_t>(at_s * 1e9 + 0.5);
}

/// What is written: on which channel, and when [s since the start]. Its one byte is its number.
struct Written {
  std::uint16_t channel;
  double at_s;
};

mcap::Bytes recording_of(const std::vector<Written>& messages, std::size_t chunk_bytes = 200) {
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk, {.chunk_bytes = chunk_bytes});
  EXPECT_TRUE(writer.begin());
  for (const char* topic :
       {"/io/state", "/io/transition", "/io/sightings", "/team/command", "/io/state"})
    (void)writer.add_channel({.topic = topic, .message_encoding = "cdr"});
  std::uint8_t number = 0;
  for (const auto& [channel, at_s] : messages) {
    EXPECT_TRUE(
        writer.write(mcap::Message{channel, number, log_ns(at_s), log_ns(at_s), {&number, 1}}));
    ++number;
  }
  EXPECT_TRUE(writer.end());
  return disk.bytes();
}

/// Ten states and ten sightings a second, for 8 s; a transition each second.
std::vector<Written> a_run() {
  std::vector<Written> run;
  for (int i = 0; i < 80; ++i) {
    if (i % 10 == 0) run.push_back({kTransition, 0.1 * i});
    run.push_back({kState, 0.1 * i});
    run.push_back({kSightings, 0.1 * i + 0.01});
  }
  return run;
}

struct Got {
  std::uint16_t channel;
  double at_s;  ///< log time since the start
  bool operator==(const Got&) const = default;
};

class SeekablePlayerTest : public testing::Test {
 protected:
  void open(mcap::Bytes bytes) {
    file = std::move(bytes);
    source.emplace(file);
    summary = mcap::summarize(*source).value();
    player.emplace(*source, summary, kTopics, clock);
  }
  /// Takes what is due now.
  std::vector<Got> take() {
    std::vector<Got> got;
    while (const auto* message = player->due()) {
      got.push_back({message->channel_id,
                     std::round(static_cast<double>(message->log_ns - kStart_ns) * 1e-6) / 1e3});
      player->take();
    }
    return got;
  }
  /// Lets time pass as the player wants to be asked, and takes what comes.
  std::vector<Got> play(double for_s) {
    std::vector<Got> got = take();
    const Time end = clock.now() + from_seconds(for_s);
    while (clock.now() < end) {
      const auto rest = player->until_next().value_or(end - clock.now());
      clock.advance(std::clamp(rest, Duration(1), end - clock.now()));
      std::ranges::copy(take(), std::back_inserter(got));
    }
    return got;
  }
  [[nodiscard]] double now_s() const {
    return static_cast<double>(player->now_ns() - kStart_ns) * 1e-9;
  }

  SteppedClock clock;
  mcap::Bytes file;
  std::optional<mcap::MemorySource> source;
  mcap::Summary summary;
  std::optional<SeekablePlayer> player;
};

TEST_F(SeekablePlayerTest, PlaysEachMessageOnceAtItsTime) {
  open(recording_of(a_run()));
  player->want({kState, kTransition, kSightings});
  const auto got = play(20);
  ASSERT_EQ(got.size(), a_run().size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].channel, a_run()[i].channel);
    EXPECT_NEAR(got[i].at_s, a_run()[i].at_s, 1e-6);
  }
  EXPECT_EQ(player->status(), SeekablePlayer::Status::kEnded);
  EXPECT_EQ(player->now_ns(), player->end_ns());
  EXPECT_FALSE(player->until_next().has_value());
}

TEST_F(SeekablePlayerTest, PlaysAtItsSpeed) {
  for (const double speed : {0.1, 2.0, 100.0}) {
    open(recording_of(a_run()));
    player->set_speed(speed);
    player->want({kState});
    const auto got = play(2 / speed - 1e-6);
    EXPECT_EQ(got.size(), 20u) << speed;
    EXPECT_NEAR(now_s(), 2, 1e-3) << speed;
  }
}

TEST_F(SeekablePlayerTest, SeeksToHowThingsStoodThen) {
  open(recording_of(a_run()));
  player->want({kState, kTransition, kSightings, kCommand});
  (void)take();
  for (const double at_s : {5.05, 2.55, 7.05}) {
    player->seek(log_ns(at_s));
    EXPECT_NEAR(now_s(), at_s, 1e-6);
    const auto got = take();
    const auto of = [&](std::uint16_t channel) {
      std::vector<double> times;
      for (const auto& each : got)
        if (each.channel == channel) times.push_back(each.at_s);
      return times;
    };
    ASSERT_EQ(of(kState).size(), 1u);
    EXPECT_NEAR(of(kState)[0], at_s - 0.05, 1e-6) << "the newest before";
    EXPECT_EQ(of(kTransition).size(), static_cast<std::size_t>(at_s) + 1) << "all of the last 30 s";
    ASSERT_EQ(of(kSightings).size(), 1u);
    EXPECT_NEAR(of(kSightings)[0], at_s - 0.04, 1e-6);
    EXPECT_TRUE(std::ranges::is_sorted(got, {}, &Got::at_s));
  }
  const auto next = play(0.06);
  EXPECT_EQ(next, (std::vector<Got>{{kState, 7.1}, {kSightings, 7.11}}));
}

TEST_F(SeekablePlayerTest, OfAStateTheNewestCountsOfWhateverWriter) {
  open(recording_of({{kState, 0}, {kState, 1}, {kStateAnew, 2}, {kStateAnew, 3}, {kState, 4}}));
  player->pause(true);
  player->want({kState, kStateAnew});
  for (const double at_s : {0.5, 1.5, 2.5, 4.0}) {
    player->seek(log_ns(at_s));
    const auto got = take();
    ASSERT_EQ(got.size(), 1u) << at_s;
    EXPECT_NEAR(got[0].at_s, std::ceil(at_s) - 1, 1e-6);
  }
}

TEST_F(SeekablePlayerTest, AMessageOfTheInstantItselfIsPlayedAndNotTold) {
  open(recording_of({{kState, 0}, {kState, 1}, {kState, 2}}));
  player->want({kState});
  player->seek(log_ns(1));
  EXPECT_EQ(take(), (std::vector<Got>{{kState, 0}, {kState, 1}}));
}

TEST_F(SeekablePlayerTest, TellsHowThingsStandWhilePaused) {
  open(recording_of(a_run()));
  player->pause(true);
  player->want({kState});
  player->seek(log_ns(3.05));
  EXPECT_EQ(take(), (std::vector<Got>{{kState, 3}}));
  clock.advance(from_seconds(60));
  EXPECT_TRUE(take().empty());
  EXPECT_NEAR(now_s(), 3.05, 1e-6);
  player->want({kState, kTransition});
  EXPECT_EQ(take().size(), 4u) << "the transitions of 0, 1, 2 and 3 s, and no state again";
  player->seek(log_ns(3.15));
  EXPECT_EQ(take().back(), (Got{kState, 3.1}));
  player->pause(false);
  EXPECT_EQ(play(0.06), (std::vector<Got>{{kState, 3.2}}));
}

TEST_F(SeekablePlayerTest, SeeksOutsideOfItAreSeeksToItsEnds) {
  open(recording_of(a_run()));
  player->want({kState});
  player->seek(0);
  EXPECT_EQ(player->now_ns(), player->start_ns());
  player->seek(UINT64_MAX);
  EXPECT_EQ(player->now_ns(), player->end_ns());
  EXPECT_EQ(take(), (std::vector<Got>{{kState, 7.9}}));
  (void)play(1);
  EXPECT_EQ(player->status(), SeekablePlayer::Status::kEnded);
  player->seek(log_ns(7.85));
  EXPECT_EQ(player->status(), SeekablePlayer::Status::kPlaying);
  EXPECT_EQ(play(0.06), (std::vector<Got>{{kState, 7.8}, {kState, 7.9}}));
}

TEST_F(SeekablePlayerTest, WhoSubscribesInTheMiddleGetsWhatIsThenAndNothingTwice) {
  open(recording_of(a_run()));
  player->want({kTransition});
  auto got = play(2.45);
  player->want({kTransition, kState});
  const auto more = play(10);
  ASSERT_FALSE(more.empty());
  EXPECT_EQ(more.front(), (Got{kState, 2.4})) << "what was so when it was asked for";
  got.insert(got.end(), more.begin(), more.end());
  const auto transitions = std::ranges::count(got, kTransition, &Got::channel);
  EXPECT_EQ(transitions, 8);
  EXPECT_EQ(std::ranges::count(got, kState, &Got::channel), 80 - 24);
}

TEST_F(SeekablePlayerTest, WaitsForAViewerThatDoesNotTake) {
  open(recording_of(a_run()));
  player->want({kState});
  (void)play(1.05);
  clock.advance(from_seconds(30));
  EXPECT_NEAR(now_s(), 1.1, 1e-6) << "the time of what was not taken";
  EXPECT_EQ(take().size(), 1u) << "it goes on from there, and does not catch up";
  EXPECT_EQ(play(0.1).size(), 1u);
}

TEST_F(SeekablePlayerTest, PassesOverASilenceAtOnce) {
  open(recording_of({{kState, 0}, {kState, 1}, {kState, 100'000}, {kState, 100'001}}, 1));
  player->want({kState});
  EXPECT_EQ(play(2.5).size(), 4u);
  player->seek(log_ns(50'000));
  EXPECT_EQ(play(0.1), (std::vector<Got>{{kState, 1}, {kState, 100'000}}));
}

TEST_F(SeekablePlayerTest, IsNotSilentWhileOthersSpeak) {
  std::vector<Written> run{{kState, 0}};
  for (int i = 0; i < 200; ++i) run.push_back({kSightings, 10.0 * i});
  run.push_back({kState, 2000});
  open(recording_of(run, 1));
  player->want({kState});
  EXPECT_EQ(play(1000).size(), 1u);
  EXPECT_NEAR(now_s(), 1000, 1);
}

TEST_F(SeekablePlayerTest, DamageIsToldAndTheRestIsPlayed) {
  auto bytes = recording_of(a_run());
  const auto blocks = mcap::summarize(mcap::MemorySource(bytes)).value().blocks;
  bytes[blocks[3].offset + mcap::kRecordHead + 24] ^= 0xff;  // the checksum
  open(std::move(bytes));
  player->want({kState, kTransition, kSightings});
  const auto got = play(20);
  EXPECT_LT(got.size(), a_run().size());
  EXPECT_GT(got.size(), a_run().size() / 2);
  const auto damages = player->take_damages();
  ASSERT_EQ(damages.size(), 1u);
  EXPECT_EQ(damages[0].offset, blocks[3].offset);
  EXPECT_TRUE(damages[0].time.has_value());
  EXPECT_TRUE(player->take_damages().empty()) << "each is told once";
}

TEST_F(SeekablePlayerTest, RunsToItsEndThoughNobodyWantsAnything) {
  open(recording_of(a_run()));
  EXPECT_TRUE(play(4).empty());
  EXPECT_NEAR(now_s(), 4, 1e-3);
  EXPECT_TRUE(play(10).empty());
  EXPECT_EQ(player->status(), SeekablePlayer::Status::kEnded);
}

TEST_F(SeekablePlayerTest, RunsOnWhenNobodyWantsAnythingAnyMoreAndBeginsAgain) {
  open(recording_of(a_run()));
  player->want({kState, kSightings});
  (void)play(1.05);
  player->want({kSightings});
  for (const auto& each : play(1)) EXPECT_EQ(each.channel, kSightings);
  player->want({});
  EXPECT_TRUE(play(1).empty());
  EXPECT_NEAR(now_s(), 3.05, 1e-3);
  player->want({kState});
  EXPECT_EQ(play(0.06), (std::vector<Got>{{kState, 3.0}, {kState, 3.1}}));
}

TEST_F(SeekablePlayerTest, FindsTheStateOfAnHourAgoWithoutReadingTheHour) {
  std::vector<Written> run{{kTransition, 0}, {kState, 0}};
  for (int i = 1; i < 3600; ++i) run.push_back({kSightings, 1.0 * i});
  open(recording_of(run, 1));
  player->want({kState, kSightings});
  player->seek(log_ns(3500.5));
  EXPECT_EQ(take(), (std::vector<Got>{{kState, 0}, {kSightings, 3500}}));
}

}  // namespace
}  // namespace galilean::monitor
