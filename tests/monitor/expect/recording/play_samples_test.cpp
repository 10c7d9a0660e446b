// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/play_samples.h"

#include <gmock/gmock.h>

#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"
#include "monitor/expect/report/words.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/losses.h"
#include "tests/monitor/expect/recording/recorded_team.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;

/// A robot that wanders for three seconds and then is stuck for three.
mcap::Bytes stuck_robot() {
  RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  for (int i = 0; i < 60; ++i) {
    ++state.tick;
    state.state = i < 30 ? "wander" : "stuck";
    team.send(0.1 * i, "/io/state", state);
  }
  return team.end();
}

Judgement judge(const mcap::Bytes& bytes, std::string_view text) {
  const auto parsed = parse("a.expect", text);
  EXPECT_TRUE(parsed.ok());
  const mcap::MemorySource source(bytes);
  const auto summary = mcap::summarize(source);
  EXPECT_TRUE(summary.ok());
  Judge judge(parsed.expectations);
  const auto played = play_samples(source, summary.value(), judge);
  auto judgement = judge.finish(played.begin_ns, played.end_ns);
  judgement.silences = played.silences;
  std::ranges::copy(played.notes, std::back_inserter(judgement.notes));
  return judgement;
}

TEST(PlaySamples, GivesTheJudgeWhatARecordingHolds) {
  const auto judgement = judge(stuck_robot(),
                               "io: never state is \"stuck\" for 2 s\n"
                               "io: rate of /io/state >= 9.5 Hz, no losses\n"
                               "io: always /io/state.tick_period_s <= 0 s\n");
  ASSERT_EQ(judgement.verdicts.size(), 4U);
  EXPECT_EQ(judgement.verdicts[0].finding.outcome, Outcome::kFails);
  EXPECT_EQ(judgement.verdicts[0].finding.counterexamples.at(0).at_ns - judgement.begin_ns,
            5'000'000'000);
  for (int i = 1; i < 4; ++i)
    EXPECT_EQ(judgement.verdicts[i].finding.outcome, Outcome::kHolds) << i;
}

TEST(PlaySamples, WhatTheRecorderCountedAsMissingIsLost) {
  for (const std::uint64_t unwritten : {0, 2}) {
    RecordedTeam team;
    msg::RobotState state;
    state.robot = "io";
    for (int i = 0; i < 60; ++i) team.send(0.1 * i, "/io/state", state);
    ASSERT_TRUE(monitor::LossLog(team.writer())
                    .conclude({{.topic = "/io/state", .writer = "a", .unwritten = unwritten}}));
    const auto finding = judge(team.end(), "io: no losses of /io/state").verdicts.at(0).finding;
    EXPECT_EQ(finding.outcome, unwritten > 0 ? Outcome::kFails : Outcome::kHolds);
    if (unwritten > 0) {
      EXPECT_EQ(finding.counterexamples.at(0).values, "2 messages lost");
    }
  }
}

TEST(PlaySamples, ADamagedChunkIsNeverCountedAsHolding) {
  auto bytes = stuck_robot();
  damage_chunk_at(2.5, bytes);
  const auto judgement =
      judge(bytes, "io: never state is \"grab\"\nio: eventually state is \"stuck\"");
  ASSERT_EQ(judgement.verdicts.size(), 2U);
  EXPECT_EQ(judgement.verdicts[0].finding.outcome, Outcome::kCannotTell);
  EXPECT_THAT(judgement.notes, testing::Contains(HasSubstr("damaged: the chunk")));
}

TEST(PlaySamples, ADamagedChunkMakesUncertainOnlyWhatItsTimeCouldDecide) {
  constexpr const char* kText = "io: eventually within 2 s state is \"stuck\"";
  auto late = stuck_robot(), early = stuck_robot();
  damage_chunk_at(4.5, late);
  damage_chunk_at(1.5, early);
  EXPECT_EQ(judge(late, kText).verdicts.at(0).finding.outcome, Outcome::kFails);
  EXPECT_EQ(judge(early, kText).verdicts.at(0).finding.outcome, Outcome::kCannotTell);
}

TEST(PlaySamples, AChunkThatIsLostAtTheBeginningOrTheEndIsMissed) {
  for (const double s : {0.5, 5.8}) {
    auto bytes = stuck_robot();
    damage_chunk_at(s, bytes);
    const auto judgement = judge(bytes, "io: never state is \"grab\"");
    EXPECT_EQ(judgement.verdicts.at(0).finding.outcome, Outcome::kCannotTell) << s;
    EXPECT_THAT(judgement.notes, testing::Contains(HasSubstr("(/io/state 1"))) << s;
  }
}

/// A recording of ten states whose recorder was killed, or a copy of it.
mcap::Bytes broken_off(bool is_copy) {
  RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  state.state = "wander";
  for (int i = 0; i < 10; ++i) team.send(0.1 * i, "/io/state", state);
  if (is_copy) {
    monitor::CopyLosses losses{.file = "cut.mcap", .is_exact = false};
    losses.times = {{RecordedTeam::kBegin_ns + 900'000'001, UINT64_MAX}};
    EXPECT_TRUE(team.writer().write(monitor::metadata_of(losses)));
    return team.end();
  }
  EXPECT_TRUE(team.writer().close_chunk_if_due(RecordedTeam::kBegin_ns + 10'000'000'000));
  return team.bytes();
}

TEST(PlaySamples, WhereARecorderBrokeOffTheEndAndTheLossesCannotBeTold) {
  for (const bool is_copy : {false, true}) {
    const auto judgement = judge(broken_off(is_copy),
                                 "io: state is \"wander\" at end, no losses of ~/state\n"
                                 "io: never state is \"stuck\"\n"
                                 "io: eventually state is \"wander\"\n"
                                 "io: never state is \"wander\"");
    ASSERT_EQ(judgement.verdicts.size(), 5U);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(judgement.verdicts[i].finding.outcome, Outcome::kCannotTell) << is_copy << i;
    EXPECT_EQ(judgement.verdicts[3].finding.outcome, Outcome::kHolds);
    EXPECT_EQ(judgement.verdicts[4].finding.outcome, Outcome::kFails) << "what was seen is seen";
    EXPECT_THAT(judgement.notes,
                testing::Contains(HasSubstr(is_copy ? "the file that it was copied from"
                                                    : "the recording was not closed")));
  }
}

TEST(PlaySamples, JudgesByTheTimesAndNotByTheOrderOfTheFile) {
  RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  for (int i = 59; i >= 0; --i) {
    state.tick = static_cast<std::uint64_t>(i);
    state.state = i < 30 ? "wander" : "stuck";
    team.send(0.1 * i, "/io/state", state);
  }
  const auto judgement = judge(team.end(), "io: never state is \"stuck\" for 2 s");
  const auto& finding = judgement.verdicts.at(0).finding;
  ASSERT_EQ(finding.outcome, Outcome::kFails);
  EXPECT_NEAR(since_begin_s(finding.counterexamples.at(0).at_ns, judgement), 5, 1e-6);
  EXPECT_THAT(judgement.notes, testing::IsEmpty());
}

TEST(PlaySamples, ATimeOfAReplayPassesOverLongSilences) {
  RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  for (const double s : {0.0, 1.0, 5000.0, 5001.0}) {
    ++state.tick;
    state.overruns = s > 5000 ? 1 : 0;
    team.send(s, "/io/state", state);
  }
  const auto judgement = judge(team.end(), "io: always tick overruns = 0");
  const auto& finding = judgement.verdicts.at(0).finding;
  ASSERT_EQ(finding.outcome, Outcome::kFails);
  EXPECT_NEAR(since_begin_s(finding.counterexamples.at(0).at_ns, judgement), 2, 1e-6);
}

TEST(PlaySamples, FieldsOfTypesThatOnlyTheRecordingDefinesAreJudged) {
  MemorySink sink;
  mcap::Writer writer(sink);
  ASSERT_TRUE(writer.begin());
  const auto schema = writer.add_schema("a_msgs/msg/Level", "ros2msg", "float64 level_m\n");
  const auto channel = writer.add_channel(
      {.schema_id = schema, .topic = "/tank/level", .message_encoding = "cdr", .metadata = {}});
  for (std::uint64_t i = 0; i < 5; ++i) {
    CdrText text;
    text.add(0.5 * static_cast<double>(i));
    const auto at_ns = RecordedTeam::kBegin_ns + i * 100'000'000;
    ASSERT_TRUE(writer.write(mcap::Message{channel, 1, at_ns, at_ns, text.bytes()}));
  }
  ASSERT_TRUE(writer.end());
  const auto judgement = judge(sink.bytes_, "team: always /tank/level.level_m < 1.5 m");
  const auto& finding = judgement.verdicts.at(0).finding;
  ASSERT_EQ(finding.outcome, Outcome::kFails);
  EXPECT_NEAR(since_begin_s(finding.counterexamples.at(0).at_ns, judgement), 0.3, 1e-6);
}

TEST(PlaySamples, NeverCrashesWhereverAFileIsCutOrFlipped) {
  const auto bytes = stuck_robot();
  for (std::size_t at = 8; at < bytes.size(); at += 13) {
    auto flipped = bytes;
    flipped[at] ^= 0x80;
    const auto cut = mcap::Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
    (void)judge(flipped, "io: always tick overruns = 0");
    (void)judge(cut, "io: always tick overruns = 0");
  }
}

TEST(PlaySamples, AMessageThatIsNotWholeIsDamage) {
  RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  team.send(0, "/io/state", state);
  team.send(0.1, "/io/state", state);
  // Variables are no whole state: the channel lies about its messages.
  msg::Variables variables;
  team.send(0.2, "/io/state", variables);
  team.send(0.3, "/io/state", state);
  const auto judgement = judge(team.end(), "io: always tick overruns = 0");
  EXPECT_EQ(judgement.verdicts.at(0).finding.outcome, Outcome::kCannotTell);
  EXPECT_THAT(judgement.notes, testing::Contains(HasSubstr("not whole")));
}

}  // namespace
}  // namespace galilean::expect
