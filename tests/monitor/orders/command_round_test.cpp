// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/command_round.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "core/wire/topic_names.h"
#include "tests/free_domain.h"
#include "tests/monitor/scripted_robot.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Word = Operator::Word;

const int kRoundDomain = free_domain();
const Addressees kWholeTeam{.robots = {}, .team = true};

/// Tells, as a monitor does, of a robot that was heard a moment ago and hangs now.
class MonitorThatKnows {
 public:
  explicit MonitorThatKnows(const std::string& robot)
      : participant_(wire::Participant::join("monitor", kRoundDomain).value()),
        objects_(*participant_, wire::kObjectsTopic) {
    msg::ObjectMap map;
    map.robots.resize(1);
    map.robots[0].name = robot;
    (void)objects_.write(map);
  }

 private:
  std::unique_ptr<wire::Participant> participant_;
  wire::Writer<msg::ObjectMap> objects_;
};

std::vector<std::string> lines_of_outcomes(const std::vector<CommandOutcome>& outcomes) {
  std::vector<std::string> lines;
  for (const auto& [robot, words, is_well] : outcomes)
    lines.push_back((is_well ? "" : "FAILED ") + robot + ": " + words);
  return lines;
}

std::vector<std::string> told_to(const Addressees& whom, Word word) {
  const auto session = OrderSession::join("test", kRoundDomain);
  return lines_of_outcomes(CommandRound(*session.value(), word, whom).run().value());
}

TEST(CommandRound, ARobotThatOnlyAMonitorKnowsIsNamedWhateverTheTeamIsTold) {
  ScriptedRobot io("io", kRoundDomain, "{}");
  const MonitorThatKnows monitor("callisto");
  const auto lines = [](Word word) { return told_to(kWholeTeam, word); };
  const auto unknown = HasSubstr("FAILED callisto: has sent nothing for ");
  EXPECT_THAT(lines(Word::kHold), ElementsAre(unknown, "io: stands still"));
  EXPECT_TRUE(io.held());
  EXPECT_THAT(lines(Word::kResume), ElementsAre(unknown, "io: goes on"));
  EXPECT_THAT(lines(Word::kStart),
              ElementsAre(unknown, "io: its bumper was pushed, but it stays in start"));
  EXPECT_THAT(lines(Word::kDecommission), ElementsAre(unknown, "io: is out of service"));
  EXPECT_THAT(lines(Word::kCommission), ElementsAre(unknown, "io: is in service again"));
}

TEST(CommandRound, WhatAnotherOperatorSteersIsStoppedAndNothingElse) {
  ScriptedRobot io("io", kRoundDomain, "{}");
  const auto monitor = wire::Participant::join("monitor", kRoundDomain).value();
  wire::Writer<msg::LeaseChange> changes(*monitor, wire::kLeaseChangeTopic);
  msg::LeaseChange change;
  change.robot = "io";
  change.holder = "somebody else";
  ASSERT_TRUE(changes.write(change));
  const auto session = OrderSession::join("test", kRoundDomain);
  const Addressees to_io{.robots = {"io"}};
  ASSERT_TRUE(session.value()->find(to_io));
  ASSERT_TRUE(session.value()->wait(OrderSession::kHear, [&] {
    return !session.value()->check_leases(to_io);
  })) << "the change was not heard";
  const auto resumed = CommandRound(*session.value(), Word::kResume, to_io).run();
  ASSERT_FALSE(resumed);
  EXPECT_THAT(resumed.error().message, HasSubstr("somebody else steers io"));
  EXPECT_THAT(lines_of_outcomes(CommandRound(*session.value(), Word::kHold, to_io).run().value()),
              ElementsAre("io: stands still"));
  change.holder = "";
  ASSERT_TRUE(changes.write(change));
  ASSERT_TRUE(session.value()->wait(OrderSession::kHear,
                                    [&] { return session.value()->check_leases(to_io).ok(); }));
  EXPECT_TRUE(CommandRound(*session.value(), Word::kResume, to_io).run());
}

TEST(CommandRound, TheOthersObeyWhereOneThatIsNamedIsNotThere) {
  ScriptedRobot io("io", kRoundDomain, "{}");
  EXPECT_THAT(told_to({.robots = {"io", "europa"}}, Word::kHold),
              ElementsAre("io: stands still", "FAILED europa: sends no state"));
  EXPECT_TRUE(io.held());
}

TEST(CommandRound, ARobotThatComesBackWhileItWaitsIsStillHeld) {
  const ScriptedRobot io("io", kRoundDomain, "{}");
  const MonitorThatKnows monitor("callisto");
  std::unique_ptr<ScriptedRobot> callisto;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    callisto = std::make_unique<ScriptedRobot>("callisto", kRoundDomain, "{}");
  });
  EXPECT_THAT(told_to(kWholeTeam, Word::kHold),
              ElementsAre("callisto: stands still", "io: stands still"));
  later.join();
}

}  // namespace
}  // namespace galilean::monitor
