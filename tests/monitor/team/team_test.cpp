// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/team.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/wire/cdr_bytes.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

msg::RobotState state_of(const std::string& robot, const std::string& hash,
                         std::uint64_t tick = 1) {
  msg::RobotState state;
  state.robot = robot;
  state.program_hash = hash;
  state.state = "wander_for_trash";
  state.tick = tick;
  state.tick_period_s = 0.05F;
  state.tick_time_max_us = 20;
  return state;
}

msg::Transition transition(std::uint64_t number) {
  msg::Transition result;
  result.robot = "io";
  result.number = number;
  return result;
}

/// What a robot answers that swapped at `tick`, by a clock that shows `stamp_s`. Tick 0: it did
/// not.
msg::ProgramReply reply_of(const std::string& hash, std::uint64_t tick, std::int32_t stamp_s) {
  msg::ProgramReply reply;
  reply.robot = "io";
  reply.running_hash = hash;
  reply.tick = tick;
  reply.stamp.sec = stamp_s;
  return reply;
}

class TeamTest : public testing::Test {
 protected:
  [[nodiscard]] RobotStatus status(const std::string& robot) const {
    return team.status(*team.find(robot));
  }

  SteppedClock clock;
  Team team{clock, 2s};
};

TEST_F(TeamTest, ASilentRobotStaysWithItsAge) {
  team.note(state_of("io", "a"));
  clock.advance(1900ms);
  EXPECT_EQ(status("io").health, Health::kWell);
  clock.advance(10min);
  EXPECT_EQ(status("io").health, Health::kSilent);
  EXPECT_DOUBLE_EQ(status("io").age_s, 601.9);
  EXPECT_EQ(status("io").state, "wander_for_trash");
  team.note(state_of("io", "a"));
  EXPECT_EQ(status("io").health, Health::kWell);
}

TEST_F(TeamTest, ARobotWithProblemsOrLateTicksIsTroubled) {
  auto state = state_of("io", "a");
  state.problems = {"the camera /dev/video0 is gone"};
  team.note(state);
  EXPECT_EQ(status("io").health, Health::kTroubled);
  state.problems.clear();
  state.tick_time_max_us = 51'000;
  team.note(state);
  EXPECT_EQ(status("io").health, Health::kTroubled);
}

TEST_F(TeamTest, WhoRunsAnotherProgramThanMostDrifts) {
  team.note(state_of("io", "a"));
  team.note(state_of("ganymede", "a"));
  team.note(state_of("callisto", "b"));
  EXPECT_FALSE(status("io").drifting);
  EXPECT_TRUE(status("callisto").drifting);
}

TEST_F(TeamTest, APushToTheTeamDecidesOnceOneRobotRunsIt) {
  team.note(state_of("io", "a"));
  team.note(state_of("ganymede", "a"));
  team.note_push("b");
  EXPECT_EQ(team.program_hash(), "a") << "nobody took it";
  team.note(state_of("ganymede", "b"));
  EXPECT_EQ(team.program_hash(), "b");
  EXPECT_TRUE(status("io").drifting);
}

TEST_F(TeamTest, CertaintyDecaysBetweenMessages) {
  msg::Variables variables;
  variables.robot = "io";
  variables.items = {{.name = "trash", .valid = true, .certainty = 0.9F, .decay_per_s = 0.1F},
                     {.name = "shaft", .valid = true, .certainty = 1, .decay_per_s = 0},
                     {.name = "basket", .valid = false, .certainty = 0.1F}};
  team.note(variables);
  clock.advance(4s);
  EXPECT_NEAR(status("io").lowest_certainty, 0.5, 1e-6);
  EXPECT_EQ(status("io").least_certain, "trash");
  clock.advance(1min);
  EXPECT_EQ(status("io").lowest_certainty, 0);
}

TEST_F(TeamTest, RepeatedAndLateTransitionsFallIntoTheirPlaces) {
  for (const std::uint64_t number : {3, 1, 2, 2, 3}) team.note(transition(number));
  std::vector<std::uint64_t> numbers;
  for (const auto& known : team.find("io")->transitions) numbers.push_back(known.number);
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(TeamTest, ARobotThatStartsAnewForgetsItsTransitions) {
  team.note(state_of("io", "a", 1000));
  team.note(transition(7));
  team.note(state_of("io", "a", 1));
  EXPECT_TRUE(team.find("io")->transitions.empty());
}

TEST_F(TeamTest, TellsWhichTransitionsFillAGap) {
  team.note(transition(1));
  for (const std::uint64_t number : {2, 3, 4, 3}) team.note(transition(number), true);
  team.note(transition(5));
  team.note(transition(9), true);
  const Robot& io = *team.find("io");
  EXPECT_EQ(io.filled, (std::vector<NumberRange>{{2, 4}, {9, 9}}));
  for (const std::uint64_t number : {2, 3, 4, 9}) EXPECT_TRUE(io.is_filled(number)) << number;
  for (const std::uint64_t number : {1, 5, 8, 10}) EXPECT_FALSE(io.is_filled(number)) << number;
}

TEST_F(TeamTest, RemembersTheNewestRangesThatFillGaps) {
  for (std::uint64_t number = 1; number <= 2 * (Robot::kFilledKept + 5); number += 2)
    team.note(transition(number), true);
  const Robot& io = *team.find("io");
  ASSERT_EQ(io.filled.size(), Robot::kFilledKept);
  EXPECT_EQ(io.filled.front().first, 11U);
}

TEST_F(TeamTest, WhatARestartedRobotDidInTheGapIsKept) {
  const auto at = [](msg::Transition made, std::int32_t stamp_s) {
    made.stamp.sec = stamp_s;
    return made;
  };
  auto last = state_of("io", "a", 1000);
  last.stamp.sec = 100;
  team.note(last);
  for (const std::uint64_t number : {1, 2, 3}) team.note(at(transition(number), 50));
  for (const std::uint64_t number : {1, 2}) team.note(at(transition(number), 150), true);
  auto anew = state_of("io", "a", 10);
  anew.stamp.sec = 160;
  team.note(anew);
  const Robot& io = *team.find("io");
  ASSERT_EQ(io.transitions.size(), 2U);
  EXPECT_EQ(io.transitions[0].stamp.sec, 150);
  EXPECT_EQ(io.filled, (std::vector<NumberRange>{{1, 2}}));
}

TEST_F(TeamTest, AnAnswerCountsBeforeTheNextState) {
  team.note(state_of("io", "a", 10));
  team.note(reply_of("b", 11, 100));
  team.note(reply_of("b", 0, 101));  // another push was refused
  EXPECT_EQ(team.find("io")->running_hash(), "b");
  team.note(state_of("io", "a", 10));  // it was under way
  EXPECT_EQ(team.find("io")->running_hash(), "b");
  team.note(state_of("io", "c", 12));
  EXPECT_EQ(team.find("io")->running_hash(), "c");
}

TEST_F(TeamTest, AClockThatIsSetBackKeepsNoAnswerNewest) {
  team.note(state_of("io", "a", 10));
  team.note(reply_of("b", 11, 3700));
  team.note(reply_of("a", 30, 100));  // it went back, by a clock that was set back by an hour
  EXPECT_EQ(team.find("io")->running_hash(), "a");
  team.note(state_of("io", "a", 31));
  EXPECT_EQ(team.find("io")->running_hash(), "a");
}

TEST_F(TeamTest, WhatARobotAnsweredBeforeItWasRestartedIsOver) {
  team.note(state_of("io", "a", 1000));
  team.note(reply_of("b", 1001, 100));
  team.note(state_of("io", "a", 3));
  EXPECT_EQ(team.find("io")->running_hash(), "a");
  team.note(reply_of("c", 5, 200));
  EXPECT_EQ(team.find("io")->running_hash(), "c");
}

TEST_F(TeamTest, ARobotThatDiedBeforeIsKnownFromTheMonitor) {
  clock.advance(1h);
  team.note(state_of("io", "a"));
  msg::ObjectMap map;
  for (const auto& [name, age_s] : {std::pair{"io", 50.F}, {"ganymede", 7.5F}, {"callisto", NAN}})
    map.robots.emplace_back().name = name, map.robots.back().age_s = age_s;
  team.note(map);
  EXPECT_EQ(status("io").health, Health::kWell);
  EXPECT_EQ(status("ganymede").health, Health::kSilent);
  EXPECT_DOUBLE_EQ(status("ganymede").age_s, 7.5);
  EXPECT_EQ(status("callisto").health, Health::kSilent);
  team.note(state_of("ganymede", "a"));
  EXPECT_EQ(status("ganymede").health, Health::kWell);
}

TEST_F(TeamTest, DamagedBytesAreTold) {
  const Channel channel{1, "rt/io/state", wire::find_schema_by_ros_type(msg::RobotState::kRosType),
                        wire::Delivery::kState};
  const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(8, std::uint8_t{255});
  EXPECT_FALSE(team.receive({channel, 0, 0, bytes}));
  EXPECT_TRUE(team.robots().empty());
}

TEST_F(TeamTest, AMonitorThatTellsOfCountlessRobotsAddsOnlySoMany) {
  msg::ObjectMap map;
  map.robots.resize(20'000);
  for (std::size_t i = 0; i < map.robots.size(); ++i)
    map.robots[i].name = "invented_" + std::to_string(i);
  team.note(map);
  EXPECT_EQ(team.robots().size(), Team::kMostRobots);
  team.note(state_of("io", "a"));
  EXPECT_EQ(status("io").health, Health::kWell) << "Ingest bounds those that send messages";
}

TEST_F(TeamTest, ARobotThatWasForgottenComesBackWhenItIsHeardAndNotWhenItIsToldOf) {
  team.note(state_of("io", "a"));
  clock.advance(2h);
  team.forget("io");
  EXPECT_EQ(team.find("io"), nullptr);
  msg::ObjectMap map;
  map.robots.resize(1);
  map.robots[0].name = "io";
  team.note(map);
  EXPECT_EQ(team.find("io"), nullptr);
  team.note(state_of("io", "a"));
  EXPECT_EQ(status("io").health, Health::kWell);
}

TEST_F(TeamTest, ARobotThatIsOnlyToldOfAndLongSilentGivesItsPlaceUp) {
  msg::ObjectMap map;
  map.robots.resize(Team::kMostRobots);
  for (std::size_t i = 0; i < map.robots.size(); ++i)
    map.robots[i].name = "invented_" + std::to_string(i);
  team.note(map);
  msg::ObjectMap later;
  later.robots.resize(2);
  later.robots[0].name = "europa";
  later.robots[1].name = "themisto";
  later.robots[1].age_s = 2 * 3600;
  team.note(later);
  EXPECT_EQ(team.find("europa"), nullptr) << "all places are taken";
  clock.advance(1h);
  team.note(later);
  EXPECT_NE(team.find("europa"), nullptr);
  EXPECT_EQ(team.find("themisto"), nullptr) << "it is silent for longer than the others";
  EXPECT_EQ(team.robots().size(), Team::kMostRobots);
}

/// Receives a state of io, as the wire brings it.
class ReplayedTeamTest : public TeamTest {
 protected:
  void receive_state(bool replayed) {
    const Payload cdr = std::make_shared<const std::vector<std::uint8_t>>(state_bytes());
    ASSERT_TRUE(team.receive({channel, 0, 0, cdr, replayed}));
  }
  [[nodiscard]] bool replayed() const { return status("io").replayed; }

 private:
  /// The CDR of a RobotState of io: its stamp and name, and zeros for all that follows.
  static std::vector<std::uint8_t> state_bytes() {
    std::vector<std::uint8_t> bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 'i', 'o', 0};
    bytes.resize(400);
    return bytes;
  }

  Channel channel{1, "rt/io/state", wire::find_schema_by_ros_type(msg::RobotState::kRosType),
                  wire::Delivery::kState};
};

/// Receives a state of io with a stamp of 3600 s.
class RobotClockTest : public TeamTest {
 protected:
  void receive_at(std::int64_t received_s, bool replayed = false) {
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    msg::CdrBytes bytes;
    bytes.stamp(3600).put(std::string_view("io"));
    auto cdr = bytes.bytes();
    cdr.resize(400);
    const auto payload = std::make_shared<const std::vector<std::uint8_t>>(std::move(cdr));
    ASSERT_TRUE(team.receive({channel, received_s * kSecond_ns, 0, payload, replayed}));
  }

  Channel channel{1, "rt/io/state", wire::find_schema_by_ros_type(msg::RobotState::kRosType),
                  wire::Delivery::kState};
};

TEST_F(RobotClockTest, ThatIsAheadIsAProblemUntilItIsSet) {
  receive_at(10);
  EXPECT_DOUBLE_EQ(status("io").clock_ahead_s, 3590);
  ASSERT_EQ(status("io").problems.size(), 1U);
  EXPECT_EQ(status("io").problems[0],
            "its clock is 3590 s ahead of this machine's; set the clock of one of them");
  EXPECT_EQ(status("io").health, Health::kTroubled);
  receive_at(3598);
  EXPECT_DOUBLE_EQ(status("io").clock_ahead_s, 0);
  EXPECT_TRUE(status("io").problems.empty());
  receive_at(7200);
  EXPECT_TRUE(status("io").problems.empty()) << "what is behind may be late";
}

TEST_F(RobotClockTest, OfARecordingSaysNothing) {
  receive_at(10, true);
  EXPECT_TRUE(status("io").problems.empty());
}

TEST_F(ReplayedTeamTest, ARobotThatAReplaySendsIsReplayedUntilItComesToLife) {
  receive_state(true);
  EXPECT_TRUE(replayed());
  EXPECT_EQ(team.replayed(), std::vector<std::string>{"io"});
  clock.advance(10min);
  EXPECT_TRUE(replayed()) << "the replay has ended, and nobody was heard since";
  receive_state(false);
  EXPECT_FALSE(replayed());
  EXPECT_EQ(team.replayed(), std::vector<std::string>{});
}

TEST_F(ReplayedTeamTest, ARobotThatIsPlayedHasNoSayInWhatTheTeamRuns) {
  receive_state(true);
  auto recorded = state_of("io", "a");
  team.note(recorded);
  recorded.robot = "ganymede";
  team.note(recorded);
  team.note_replay("ganymede");
  EXPECT_EQ(team.program_hash(), "a") << "there is nobody else";
  team.note(state_of("callisto", "b"));
  EXPECT_EQ(team.program_hash(), "b");
  EXPECT_FALSE(status("callisto").drifting);
  EXPECT_FALSE(status("io").drifting);
}

TEST_F(ReplayedTeamTest, ARobotThatIsLiveAndPlayedAtOnceIsReplayed) {
  for (int i = 0; i < 5; ++i) {
    receive_state(true);
    clock.advance(500ms);
    receive_state(false);
    EXPECT_TRUE(replayed());
  }
  clock.advance(2s);
  receive_state(false);
  EXPECT_FALSE(replayed());
}

}  // namespace
}  // namespace galilean::monitor
