// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/player.h"

#include <gtest/gtest.h>

#include <optional>

#include "monitor/mcap/mcap_writer.h"
#include "monitor/playback/replay_clock.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {
namespace {

constexpr std::uint64_t kStart_ns = 1'700'000'000'000'000'000;
constexpr std::uint16_t kState = 1, kTransition = 2, kSightings = 3;

/// When a message was sent, in seconds since the playing began, on which channel, and its one byte.
struct Sent {
  double at_s;
  std::uint16_t channel;
  int byte;
  bool operator==(const Sent&) const = default;
};

/// Ten messages a second on each of three channels, for so many seconds; each is one byte, counted
/// up.
mcap::FaultyDisk recording_of(int duration_s) {
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk, {.chunk_bytes = 400});
  EXPECT_TRUE(writer.begin());
  for (const char* topic : {"/io/state", "/io/transition", "/io/sightings"})
    (void)writer.add_channel({.topic = topic, .message_encoding = "cdr"});
  for (std::uint8_t i = 0; i < duration_s * 10; ++i)
    for (const auto channel : {kState, kTransition, kSightings}) {
      const std::uint64_t log_ns = kStart_ns + i * 100'000'000ULL;
      EXPECT_TRUE(writer.write(mcap::Message{channel, i, log_ns, log_ns - 5000, {&i, 1}}));
    }
  EXPECT_TRUE(writer.end());
  return disk;
}

const std::map<std::uint16_t, Track> kAll{
    {kState, {"rt/io/state", "galilean_msgs/msg/RobotState", wire::Delivery::kState}},
    {kTransition, {"rt/io/transition", "galilean_msgs/msg/Transition", wire::Delivery::kEvent}},
    {kSightings, {"rt/io/sightings", "galilean_msgs/msg/Sightings", wire::Delivery::kStream}}};

/// Plays on a stepped clock: waiting moves it on, until `end_s`.
std::vector<Sent> played(mcap::ByteView file, Pace pace,
                         const std::map<std::uint16_t, Track>& tracks = kAll, double end_s = 1e9) {
  SteppedClock clock;
  std::vector<Sent> sent;
  Player player(
      tracks, pace, clock,
      [&](std::uint16_t channel, mcap::ByteView cdr) {
        EXPECT_EQ(cdr.size(), 1u);
        sent.push_back({to_seconds(clock.now() - Time{}), channel, cdr[0]});
      },
      [&](Time due) {
        if (to_seconds(due - Time{}) > end_s) return false;
        if (due > clock.now()) clock.advance(due - clock.now());
        return true;
      });
  const mcap::MemorySource source(file);
  (void)player.play(source, mcap::summarize(source).value().blocks);
  EXPECT_EQ(player.sent(), sent.size());
  return sent;
}

TEST(Player, SendsEachMessageAsLongAfterTheFirstAsItWasReceived) {
  const auto file = recording_of(2);
  const auto sent = played(file.bytes(), {});
  ASSERT_EQ(sent.size(), 60u);
  for (std::size_t i = 0; i < sent.size(); ++i) {
    EXPECT_NEAR(sent[i].at_s, static_cast<double>(i / 3) * 0.1, 1e-6);
    EXPECT_EQ(sent[i].channel, 1 + i % 3);
    EXPECT_EQ(sent[i].byte, static_cast<int>(i / 3));
  }
}

TEST(Player, PlaysFasterAndSlower) {
  const auto file = recording_of(2);
  EXPECT_NEAR(played(file.bytes(), {.rate = 4}).back().at_s, 1.9 / 4, 1e-6);
  EXPECT_NEAR(played(file.bytes(), {.rate = 0.5}).back().at_s, 1.9 * 2, 1e-6);
}

TEST(Player, BeginsWithWhatALateJoinerWouldBeTold) {
  const auto file = recording_of(10);
  const auto sent = played(file.bytes(), {.from = from_seconds(8)});
  const auto events = std::count_if(sent.begin(), sent.end(), [](const Sent& each) {
    return each.channel == kTransition && each.at_s == 0 && each.byte < 80;
  });
  EXPECT_EQ(events, 64);
  EXPECT_EQ(sent.front(), (Sent{0, kTransition, 16}));
  const auto first_state = std::find_if(sent.begin(), sent.end(),
                                        [](const Sent& each) { return each.channel == kState; });
  EXPECT_EQ(*first_state, (Sent{0, kState, 79}));
  const auto first_sightings = std::find_if(
      sent.begin(), sent.end(), [](const Sent& each) { return each.channel == kSightings; });
  EXPECT_EQ(first_sightings->byte, 80);
  EXPECT_NEAR(sent.back().at_s, 1.9, 1e-6);
}

TEST(Player, EndsAfterTheLastMessageThatIsWanted) {
  const auto file = recording_of(10);
  const auto sent = played(file.bytes(), {.from = from_seconds(8), .until = from_seconds(8.45)});
  EXPECT_NEAR(sent.back().at_s, 0.4, 1e-6);
  EXPECT_EQ(sent.back().byte, 84);
}

TEST(Player, PlaysWhatIsWholeOfATruncatedFile) {
  const auto file = recording_of(10);
  const auto whole = played(file.bytes(), {});
  for (const std::size_t bytes : {file.bytes().size() / 2, file.bytes().size() / 3}) {
    const auto sent = played(mcap::ByteView(file.bytes()).first(bytes), {});
    ASSERT_GT(sent.size(), 10u);
    ASSERT_LT(sent.size(), whole.size());
    EXPECT_TRUE(std::equal(sent.begin(), sent.end(), whole.begin()));
  }
}

/// One message of one byte a chunk, so many milliseconds behind the start; none is stamped 0.
mcap::FaultyDisk recording_at(const std::vector<std::optional<int>>& times_ms) {
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk, {.chunk_bytes = 1});
  EXPECT_TRUE(writer.begin());
  (void)writer.add_channel({.topic = "/io/state", .message_encoding = "cdr"});
  for (std::uint8_t i = 0; i < times_ms.size(); ++i) {
    const auto at_ms = times_ms[i];
    const std::uint64_t log_ns =
        at_ms ? kStart_ns + static_cast<std::uint64_t>(*at_ms) * 1'000'000 : 0;
    EXPECT_TRUE(writer.write(mcap::Message{kState, i, log_ns, log_ns, {&i, 1}}));
  }
  EXPECT_TRUE(writer.end());
  return disk;
}

TEST(Player, PlaysInTheOrderOfLogTimeAcrossChunks) {
  const auto sent = played(recording_at({0, 300, 100, 200}).bytes(), {});
  ASSERT_EQ(sent.size(), 4u);
  for (const int i : {0, 1, 2, 3})
    EXPECT_NEAR(sent[static_cast<std::size_t>(i)].at_s, 0.1 * i, 1e-6);
  EXPECT_EQ(sent[1].byte, 2);
  EXPECT_EQ(sent[3].byte, 1);
}

TEST(Player, DoesNotWaitForDecadesAfterAMessageStampedZero) {
  const auto sent = played(recording_at({0, std::nullopt, 500}).bytes(), {});
  ASSERT_EQ(sent.size(), 3u);
  EXPECT_EQ(sent[0].byte, 1);
  EXPECT_NEAR(sent[2].at_s, 0.5, 1e-6);
  const auto later =
      played(recording_at({0, std::nullopt, 500}).bytes(), {.from = from_seconds(0.4)});
  ASSERT_EQ(later.size(), 2u);  // the newest state before, and the message behind
  EXPECT_NEAR(later[1].at_s, 0.1, 1e-6);
}

TEST(Player, LeavesOutWhatIsNotAskedFor) {
  const auto file = recording_of(1);
  for (const auto& each : played(file.bytes(), {}, {{kState, kAll.at(kState)}}))
    EXPECT_EQ(each.channel, kState);
}

TEST(Player, EndsWhereItIsTold) {
  const auto file = recording_of(5);
  EXPECT_EQ(played(file.bytes(), {}, kAll, 0.95).size(), 30u);
}

/// Plays with a step of the clock of a quarter of a second. Returns what time of the recording it
/// was at each, in seconds since its start.
std::vector<double> times_told(mcap::ByteView file, Pace pace) {
  constexpr auto kStep = std::chrono::milliseconds(250);
  SteppedClock clock;
  std::vector<double> told;
  Player player(
      kAll, pace, clock, [](std::uint16_t, mcap::ByteView) {},
      [&](Time due) {
        while (clock.now() < due) {
          told.push_back(static_cast<double>(*player.log_now_ns() - kStart_ns) / 1e9);
          clock.advance(kStep);
        }
        return true;
      });
  EXPECT_FALSE(player.log_now_ns());
  const mcap::MemorySource source(file);
  (void)player.play(source, mcap::summarize(source).value().blocks);
  return told;
}

using Told = std::vector<double>;

TEST(Player, TellsTheTimeOfTheRecordingBetweenMessages) {
  const auto file = recording_at({0, 1000});
  EXPECT_EQ(times_told(file.bytes(), {}), (Told{0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(times_told(file.bytes(), {.rate = 2}), (Told{0, 0.5}));
  EXPECT_EQ(times_told(file.bytes(), {.from = from_seconds(0.5)}), (Told{0.5, 0.75}));
}

TEST(Player, TellsTheTimeBehindASilence) {
  const auto file = recording_at({0, 500, 1'000'500, 1'001'000});
  EXPECT_EQ(times_told(file.bytes(), {}), (Told{0, 0.25, 1000.5, 1000.75}));
}

TEST(Player, TellsNoTimeThatItHasNotReached) {
  const auto file = recording_at({0, 1000});
  SteppedClock clock;
  Player player(
      kAll, {}, clock, [](std::uint16_t, mcap::ByteView) {},
      [&](Time) {
        clock.advance(std::chrono::seconds(5));  // somebody kept the process from running
        return true;
      });
  const mcap::MemorySource source(file.bytes());
  (void)player.play(source, mcap::summarize(source).value().blocks);
  EXPECT_EQ(player.log_now_ns(), kStart_ns + 1'000'000'000);
}

TEST(Player, TellsTheSameTimeWhileItsClockStandsStill) {
  const auto file = recording_at({0, 1000});
  SteppedClock real;
  ReplayClock clock(real, 1);
  Told told;
  Player player(
      kAll, {}, clock, [](std::uint16_t, mcap::ByteView) {},
      [&](Time due) {
        clock.pause(true);
        for (int i = 0; i < 2; ++i) {
          real.advance(std::chrono::seconds(60));
          told.push_back(static_cast<double>(*player.log_now_ns() - kStart_ns) / 1e9);
        }
        clock.move_to(due);  // as a step does
        return true;
      });
  const mcap::MemorySource source(file.bytes());
  (void)player.play(source, mcap::summarize(source).value().blocks);
  EXPECT_EQ(told, (Told{0, 0, 0, 0}));
  EXPECT_EQ(player.log_now_ns(), kStart_ns + 1'000'000'000);
}

}  // namespace
}  // namespace galilean::monitor
