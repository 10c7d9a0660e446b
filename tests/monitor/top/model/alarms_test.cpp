// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/alarms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/monitor/top/model/told.h"

namespace galilean::monitor::top {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

Alarm alarm(const std::string& robot, AlarmKind kind = AlarmKind::kSilent) {
  return {robot, kind, robot, robot + " is silent", robot + " was silent"};
}

std::vector<std::string> sentences(const AlarmBoard& board, Time now) {
  std::vector<std::string> all;
  for (const auto& posted : board.posted()) all.push_back(sentence_of(posted, now));
  return all;
}

TEST(AlarmBoard, AnAlarmStaysUntilItIsOverAndSomebodyHasSeenIt) {
  AlarmBoard board;
  board.update({alarm("io")}, Time{});
  EXPECT_THAT(sentences(board, Time{seconds(4)}), ElementsAre("io is silent, for 4.0 s"));
  board.update({}, Time{seconds(5)});
  EXPECT_THAT(sentences(board, Time{seconds(9)}), ElementsAre("io was silent for 5.0 s"));
  board.acknowledge();
  EXPECT_TRUE(board.posted().empty());
}

TEST(AlarmBoard, OneThatWasSeenLastsQuietlyAndGoesWhenItIsOver) {
  AlarmBoard board;
  board.update({alarm("io")}, Time{});
  board.acknowledge({"io"});
  board.update({alarm("io"), alarm("ganymede")}, Time{seconds(3)});
  ASSERT_EQ(board.posted().size(), 2u);
  EXPECT_EQ(board.posted()[0].alarm.robot, "ganymede");
  EXPECT_TRUE(board.posted()[1].seen);
  board.update({alarm("ganymede")}, Time{seconds(4)});
  EXPECT_EQ(board.posted().size(), 1u);
}

TEST(AlarmBoard, WhatHappenedOnceIsToldByWhenItDid) {
  AlarmBoard board;
  Alarm refused = alarm("io", AlarmKind::kPush);
  refused.words = "io refused office";
  board.update({refused}, Time{});
  EXPECT_THAT(sentences(board, Time{seconds(4)}), ElementsAre("io refused office, 4.0 s ago"));
  board.update({}, Time{seconds(5)});
  EXPECT_THAT(sentences(board, Time{seconds(9)}), ElementsAre("io refused office, 9.0 s ago"));
}

TEST(AlarmBoard, WhatBeganBeforeItWasFoundIsToldByItsBeginning) {
  AlarmBoard board;
  Alarm silent = alarm("io");
  silent.since = Time{};
  board.update({silent}, Time{seconds(2)});
  EXPECT_THAT(sentences(board, Time{seconds(4)}), ElementsAre("io is silent, for 4.0 s"));
  board.update({}, Time{seconds(5)});
  EXPECT_THAT(sentences(board, Time{seconds(9)}), ElementsAre("io was silent for 5.0 s"));
}

TEST(AlarmBoard, WhatPassesAtOnceWasNone) {
  AlarmBoard board;
  board.update({alarm("io")}, Time{});
  board.update({}, Time{seconds(1)});
  EXPECT_TRUE(board.posted().empty());
}

TEST(AlarmBoard, OneThatComesAgainIsANewOne) {
  AlarmBoard board;
  board.update({alarm("io")}, Time{});
  board.acknowledge();
  board.update({}, Time{seconds(3)});
  board.update({alarm("io")}, Time{seconds(4)});
  ASSERT_EQ(board.posted().size(), 1u);
  EXPECT_FALSE(board.posted()[0].seen);
}

TEST(AlarmLines, AreGroupedByKindWhereTheyAreMany) {
  AlarmBoard board;
  std::vector<Alarm> all{alarm("europa", AlarmKind::kStuck)};
  for (int i = 0; i < 12; ++i) all.push_back(alarm("r" + std::to_string(i)));
  board.update(all, Time{});
  const auto lines = alarm_lines(board.posted(), Time{}, 2);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].robot, "europa");
  EXPECT_THAT(lines[1].text, testing::StartsWith("12 robots are silent: r0, r1, r2"));
  EXPECT_EQ(lines[1].keys.size(), 12u);
}

TEST(AlarmLines, TellWhatIsOverAsPastAndEachRobotOnce) {
  AlarmBoard board;
  board.update({alarm("r10"), alarm("r1")}, Time{});
  board.update({}, Time{seconds(3)});
  const auto text = [&] { return alarm_lines(board.posted(), Time{seconds(9)}, 1).at(0).text; };
  EXPECT_EQ(text(), "2 robots were silent: r10, r1");
  board.acknowledge();
  Alarm first = alarm("io", AlarmKind::kProblem);
  Alarm second = first;
  second.key += " another";
  board.update({first, second}, Time{seconds(10)});
  EXPECT_EQ(text(), "1 robot has problems: io");
}

class Finder : public Told {
 protected:
  std::vector<std::string> found() {
    std::vector<std::string> words;
    for (const auto& each : finder.find(model, clock.now())) words.push_back(each.words);
    return words;
  }

  AlarmFinder finder;
};

TEST_F(Finder, ASilentRobotIsAnAlarm) {
  tell_of({.x_m = 0});
  EXPECT_TRUE(found().empty());
  clock.advance(seconds(3));
  EXPECT_THAT(found(), ElementsAre("io is silent"));
}

TEST_F(Finder, WhatTheMonitorTellsOfItsHistoryAndItsMapIsAnAlarmWhileItTellsSo) {
  const auto tell_status = [this](std::uint8_t level, const std::string& name,
                                  const std::string& words = "The history is in danger.") {
    tell("rt/diagnostics", msg::DiagnosticArray::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .text("")
             .number<std::uint32_t>(1)
             .number(level)
             .text(name)
             .text(words)
             .text("")
             .number<std::uint32_t>(0));
  };
  tell_status(2, "another program");
  EXPECT_TRUE(found().empty());
  tell_status(2, "galilean-monitor: history");
  EXPECT_THAT(found(), ElementsAre("The history is in danger"));
  tell_status(2, "galilean-monitor: map", "The map has stood still for 4 s.");
  EXPECT_THAT(found(), ElementsAre("The history is in danger", "The map has stood still for 4 s"));
  tell_status(0, "galilean-monitor: map");
  tell_status(0, "galilean-monitor: history");
  EXPECT_TRUE(found().empty());
  tell_status(2, "galilean-monitor: history");
  clock.advance(seconds(6));
  EXPECT_TRUE(found().empty()) << "the monitor has ended";
}

TEST_F(Finder, ARobotThatIsForgottenIsNoAlarm) {
  tell_of({.x_m = 0});
  clock.advance(seconds(3));
  EXPECT_EQ(found().size(), 1u);
  model.forget("io");
  EXPECT_TRUE(found().empty());
  EXPECT_EQ(model.identities().of("io").letter, "?");
}

TEST_F(Finder, ARecordingThatHasEndedIsNoAlarm) {
  replayed = true;
  tell_of({.x_m = 0, .program_hash = "another"});
  replayed = false;
  tell_of({.robot = "ganymede"});
  EXPECT_TRUE(found().empty());
  clock.advance(seconds(3));
  EXPECT_THAT(found(), ElementsAre("ganymede is silent"));
}

TEST_F(Finder, OneThatDoesNotMoveIsStuckUnlessItIsHeld) {
  for (int i = 0; i < 20; ++i, clock.advance(seconds(1))) {
    tell_of({.x_m = 0.001 * i});
    EXPECT_TRUE(found().empty());
  }
  tell_of({.x_m = 0.02});
  EXPECT_THAT(found(), ElementsAre("io does not move in wander"));
  tell_of({.held = true, .x_m = 0.02});
  EXPECT_TRUE(found().empty());
  tell_of({.x_m = 0.5});
  EXPECT_TRUE(found().empty());
}

TEST_F(Finder, OneThatWaitsAtALockForAnOperatorIsNotStuck) {
  msg::Breaks breaks;
  breaks.robot = "io";
  breaks.waits_at_from = "wander";
  breaks.waits_at_to = "grab";
  for (int i = 0; i <= 20; ++i, clock.advance(seconds(1))) {
    tell_of({});
    tell_of_breaks(breaks);
    EXPECT_TRUE(found().empty());
  }
}

TEST_F(Finder, ALateTickIsToldForAWhile) {
  tell_of({.overruns = 3, .x_m = 0});
  EXPECT_TRUE(found().empty());  // late before this was started
  tell_of({.overruns = 4, .x_m = 0.1});
  EXPECT_THAT(found(), ElementsAre("io's ticks begin late (4 so far)"));
  clock.advance(seconds(21));
  tell_of({.overruns = 4, .x_m = 0.2});
  EXPECT_TRUE(found().empty());
}

}  // namespace
}  // namespace galilean::monitor::top
