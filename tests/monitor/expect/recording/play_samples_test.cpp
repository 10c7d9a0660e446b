// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/play_samples.h"

#include <gmock/gmock.h>

#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"
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

TEST(PlaySamples, ADamagedChunkIsNeverCountedAsHolding) {
  auto bytes = stuck_robot();
  bytes[bytes.size() / 2] ^= 0x55;
  const auto judgement =
      judge(bytes, "io: never state is \"grab\"\nio: eventually state is \"stuck\"");
  ASSERT_EQ(judgement.verdicts.size(), 2U);
  EXPECT_EQ(judgement.verdicts[0].finding.outcome, Outcome::kCannotTell);
  EXPECT_THAT(judgement.notes, testing::Contains(HasSubstr("damaged: the chunk")));
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
