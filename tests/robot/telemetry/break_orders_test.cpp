// SPDX-License-Identifier: BSD-3-Clause
// Orders about break points over DDS, and what a robot answers and tells.
#include <gmock/gmock.h>

#include "core/wire/ros_time.h"
#include "tests/robot/executive/branching_robot.h"
#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;
namespace kinds = msg::Command_Constants;
namespace points = msg::BreakPoint_Constants;
namespace stoppers = msg::Breaks_Constants;

std::string name_of_this_test(const std::string& suffix = "") {
  return std::string("b_") + testing::UnitTest::GetInstance()->current_test_info()->name() + suffix;
}

/// A robot on DDS that runs the branching program, and what it tells about break points.
class BreakingRobot : public TelemetryRobot {
 public:
  explicit BreakingRobot(const std::string& robot_name)
      : TelemetryRobot(robot_name), told(mailbox<msg::Breaks>("breaks")) {
    EXPECT_TRUE(robot.load(branching_text()));
    robot.tick();
  }
  /// Sends the order to this robot, and returns what it tells when it has answered.
  msg::Breaks ask(const std::string& order, std::vector<msg::BreakPoint> points) {
    msg::BreakOrder message;
    message.id = order + std::to_string(++asked_);
    message.author = "Anna";
    message.targets = {name};
    message.order = order;
    message.points = std::move(points);
    send(message);
    return told_with_answer(message.id);
  }
  msg::Breaks step(const std::string& author = "Ben") {
    msg::Command command;
    command.id = "step" + std::to_string(++asked_);
    command.author = author;
    command.targets = {name};
    command.kind = kinds::STEP;
    send(command);
    return told_with_answer(command.id);
  }
  /// Returns what it tells once it has answered the order. Requires: it is the newest order.
  msg::Breaks told_with_answer(const std::string& id) {
    return tell_when([&](const msg::Breaks& each) {
      return !each.answers.empty() && each.answers.back().id == id;
    });
  }
  msg::Breaks tell_when(const std::function<bool(const msg::Breaks&)>& is_it) {
    const auto found = told.wait_for(is_it);
    EXPECT_TRUE(found) << "it told nothing of the kind";
    return found.value_or(msg::Breaks{});
  }
  /// Makes one tick in which it goes to `state`.
  void go_to(const std::string& state) {
    const unsigned bumper = state == "grab" ? 0 : state == "rest" ? 1 : 2;
    robot.press(bumper);
    robot.tick();
    robot.press(bumper, false);
  }

  Mailbox<msg::Breaks> told;

 private:
  int asked_ = 0;
};

/// Returns why it refused the newest order; empty: it did not.
std::string refusal_in(const msg::Breaks& told) {
  return told.answers.empty() ? "it has answered nothing" : told.answers.back().refused;
}

class BreakOrdersTest : public testing::Test {
 protected:
  BreakOrdersTest() : io(name_of_this_test()) {}

  BreakingRobot io;
};

TEST_F(BreakOrdersTest, ASetIsAnsweredWithThePoints) {
  const auto set = io.ask("set", {{"wander", "grab", points::STOP}, {"", "rest", points::LOCK}});
  EXPECT_EQ(set.robot, io.name);
  EXPECT_EQ(refusal_in(set), "");
  ASSERT_EQ(set.points.size(), 2U);
  EXPECT_EQ(set.points[0], (msg::BreakPoint{"wander", "grab", points::STOP}));
  EXPECT_EQ(set.points[1], (msg::BreakPoint{"", "rest", points::LOCK}));
  EXPECT_FALSE(set.stopped);
  EXPECT_EQ(io.ask("remove", {{"", "rest", 0}}).points.size(), 1U);
  EXPECT_EQ(io.ask("clear", {}).points.size(), 0U);
}

TEST_F(BreakOrdersTest, TellsWhereItStoppedAndWhoseBreakPointItIs) {
  auto states = io.mailbox<msg::RobotState>("state");
  auto transitions = io.mailbox<msg::Transition>("transition");
  auto logs = Mailbox<msg::Log>(*io.other, wire::kLogTopic);
  io.ask("set", {{"", "grab", points::STOP}});
  io.robot.tick();
  io.go_to("grab");
  const auto stopped = io.tell_when([](const msg::Breaks& each) { return each.stopped; });
  EXPECT_EQ(stopped.stopped_by, stoppers::BREAK_POINT);
  EXPECT_EQ(stopped.break_robot, io.name);
  EXPECT_EQ(stopped.break_point, (msg::BreakPoint{"", "grab", points::STOP}));
  EXPECT_EQ(stopped.author, "Anna");
  const auto transition =
      transitions.wait_for([](const msg::Transition& each) { return each.to_state == "grab"; });
  ASSERT_TRUE(transition);
  EXPECT_EQ(stopped.stopped_at, transition->number);
  EXPECT_EQ(transition->cause, "bumpers[0] became 1");
  EXPECT_TRUE(states.wait_for([](const auto& each) { return each.state == "grab" && each.held; }));
  EXPECT_TRUE(logs.wait_for([&](const msg::Log& line) {
    return line.name == io.name &&
           line.msg == "stopped at break point on entering grab, set by Anna";
  }));
}

TEST_F(BreakOrdersTest, AStepIsAnsweredAndEndsAtTheNextChangeOfState) {
  EXPECT_EQ(refusal_in(io.step()), "");
  io.robot.tick();
  EXPECT_TRUE(io.robot.drive.moving);
  io.tell_when([](const msg::Breaks& each) { return each.stepping && !each.stopped; });
  io.go_to("rest");
  const auto stopped = io.tell_when([](const msg::Breaks& each) { return each.stopped; });
  EXPECT_EQ(stopped.stopped_by, stoppers::STEP);
  EXPECT_EQ(stopped.break_robot, "");
  EXPECT_EQ(stopped.break_point, msg::BreakPoint{});
  EXPECT_EQ(stopped.author, "Ben");
  EXPECT_FALSE(stopped.stepping);
  io.send(kinds::RESUME, 0, io.name);
  EXPECT_TRUE(io.tick_until([&] { return io.robot.drive.moving; }));
  EXPECT_TRUE(io.tick_until([&] {
    const msg::Breaks last = io.told.all().back();
    return !last.stopped && last.stopped_by == stoppers::NOTHING && last.stopped_at == 0 &&
           !last.stepping;
  }));
}

TEST_F(BreakOrdersTest, AStepOfARobotThatAnOperatorHoldsIsRefused) {
  io.send(kinds::HOLD, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.executive->held(); }));
  const auto refused = io.step();
  EXPECT_EQ(refusal_in(refused),
            io.name + " is held by tester, not at a break point: resume it first");
  EXPECT_FALSE(refused.stopped);
  io.robot.tick();
  EXPECT_FALSE(io.robot.drive.moving);
}

TEST_F(BreakOrdersTest, AStepOfARobotThatIsOutOfServiceIsRefused) {
  io.send(kinds::DECOMMISSION, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return !io.robot.executive->in_service(); }));
  EXPECT_EQ(refusal_in(io.step()), io.name + " is out of service: commission it first");
}

TEST_F(BreakOrdersTest, SaysWhatIsWrongWithAnOrderAndChangesNothing) {
  io.ask("set", {{"wander", "grab", points::STOP}});
  const auto expect_refused = [&](const msg::Breaks& answer, const std::string& why) {
    EXPECT_THAT(refusal_in(answer), HasSubstr(why));
    EXPECT_EQ(answer.points.size(), 1U);
  };
  expect_refused(io.ask("forget", {}), "there is no order 'forget'");
  expect_refused(io.ask("set", {}), "names no break point");
  expect_refused(io.ask("set", {{"", "rest", points::STOP}, {"", "grab", 7}}),
                 "no kind 7 of break point: it must be stop, stop_team or lock");
  expect_refused(io.ask("set", {{"", "", points::STOP}}), "must name the state");
  expect_refused(io.ask("remove", {{"grab", "wander", 0}}), "no break point grab -> wander");
  expect_refused(io.ask("let_through", {{"wander", "grab", 0}}), "no lock wander -> grab");
  std::vector<msg::BreakPoint> many;
  for (int i = 0; i < 32; ++i) many.push_back({"", std::to_string(i), points::STOP});
  expect_refused(io.ask("set", many), "33 break points");
  many.push_back({"", "one more", points::STOP});
  expect_refused(io.ask("set", many), "names 33 break points, and 32 are the most");
  EXPECT_EQ(refusal_in(io.ask("clear", {})), "");
}

TEST_F(BreakOrdersTest, TellsAtWhichLockItWaitsUntilItIsLetThrough) {
  io.ask("set", {{"", "grab", points::LOCK}});
  io.robot.press(0);
  io.robot.tick(4);
  const auto waits =
      io.tell_when([](const msg::Breaks& each) { return !each.waits_at_to.empty(); });
  EXPECT_EQ(waits.waits_at_from, "wander");
  EXPECT_EQ(waits.waits_at_to, "grab");
  EXPECT_LE(wire::since_epoch_ns(waits.waits_since), wire::since_epoch_ns(waits.stamp));
  EXPECT_GT(waits.waits_since.sec, 0);
  EXPECT_EQ(refusal_in(io.ask("let_through", {{"wander", "grab", 0}})), "");
  io.robot.tick();
  EXPECT_EQ(io.robot.state(), "grab");
  io.tell_when([](const msg::Breaks& each) {
    return !each.answers.empty() && each.answers.back().id.starts_with("let_through") &&
           each.waits_at_to.empty();
  });
}

TEST_F(BreakOrdersTest, ALateJoinerLearnsThemAndEachSecondAnew) {
  io.ask("set", {{"wander", "grab", points::STOP}});
  auto late = io.mailbox<msg::Breaks>("breaks");
  ASSERT_TRUE(late.wait_for([](const msg::Breaks& each) { return each.points.size() == 1; }));
  const auto count = [&] { return late.all().size(); };
  const auto before = count();
  io.robot.tick(25);
  EXPECT_TRUE(io.tick_until([&] { return count() > before; }));
}

TEST_F(BreakOrdersTest, TwoOperatorsWhoOrderAtOnceBothFindTheirAnswers) {
  msg::BreakOrder order;
  order.targets = {io.name};
  order.points = {{"", "grab", points::STOP}};
  for (const char* id : {"Anna's", "Ben's"}) {
    order.id = id;
    order.order = order.id == "Anna's" ? "set" : "forget";
    io.send(order);
  }
  const auto told = io.told_with_answer("Ben's");
  ASSERT_EQ(told.answers.size(), 2U);
  EXPECT_EQ(told.answers[0], (msg::BreakAnswer{"Anna's", ""}));
  EXPECT_EQ(told.answers[1].id, "Ben's");
  EXPECT_THAT(told.answers[1].refused, HasSubstr("there is no order 'forget'"));
}

TEST_F(BreakOrdersTest, OnlyTheNewestAnswersAreKept) {
  const std::size_t kept = BreakDesk::kAnswersKept;
  for (std::size_t i = 0; i <= kept; ++i) io.ask("clear", {});
  const auto answers = io.told.all().back().answers;
  ASSERT_EQ(answers.size(), kept);
  EXPECT_EQ(answers.front().id, "clear2");
  EXPECT_EQ(answers.back().id, "clear" + std::to_string(kept + 1));
}

TEST_F(BreakOrdersTest, AnothersOrderIsNoneOfItsBusinessAndAStrangersIsObeyed) {
  const auto stranger = wire::Participant::join("stranger", kDomain);
  wire::Writer<msg::BreakOrder> orders(*stranger.value(), wire::kBreakOrderTopic);
  while (orders.readers() == 0) std::this_thread::yield();
  msg::BreakOrder order;
  order.order = "set";
  order.points = {{"", "rest", points::STOP}};
  order.targets = {"ganymede"};
  order.id = "another's";
  ASSERT_TRUE(orders.write(order));
  order.targets = {};
  order.id = "everybody's";
  order.points = {{"", "grab", points::STOP}};
  ASSERT_TRUE(orders.write(order));
  const auto told = io.told_with_answer(order.id);
  ASSERT_EQ(told.points.size(), 1U);
  EXPECT_EQ(told.points[0].to_state, "grab");
}

TEST_F(BreakOrdersTest, ABreakPointOfOneStopsTheTeamAndAStepLetsTheOtherGo) {
  io.ask("set", {{"wander", "grab", points::STOP_TEAM}});
  BreakingRobot ganymede(name_of_this_test("_too"));
  ganymede.robot.tick();
  ASSERT_TRUE(ganymede.robot.drive.moving);
  // What io writes from now on reaches both.
  const wire::Writer<msg::TeamStop> probe(*io.participant, wire::kTeamStopTopic);
  ASSERT_TRUE(io.tick_until([&] { return probe.readers() >= 2; }));
  io.go_to("grab");
  EXPECT_FALSE(io.robot.drive.moving);
  ASSERT_TRUE(ganymede.tick_until([&] { return !ganymede.robot.drive.moving; }));
  const auto stopped = ganymede.tell_when([](const msg::Breaks& each) { return each.stopped; });
  EXPECT_EQ(stopped.stopped_by, stoppers::TEAM);
  EXPECT_EQ(stopped.break_robot, io.name);
  EXPECT_EQ(stopped.break_point, (msg::BreakPoint{"wander", "grab", points::STOP_TEAM}));
  EXPECT_EQ(stopped.author, "Anna");
  EXPECT_EQ(stopped.stopped_at, 0U);
  EXPECT_EQ(refusal_in(ganymede.step()), "");
  ganymede.robot.tick();
  EXPECT_TRUE(ganymede.robot.drive.moving);
}

TEST_F(BreakOrdersTest, WhatStopsTheTeamLeavesAHeldRobotHeld) {
  io.send(kinds::HOLD, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.executive->held(); }));
  msg::TeamStop stop;
  stop.robot = "ganymede";
  io.send(stop);
  const auto told = io.step();
  EXPECT_THAT(refusal_in(told), HasSubstr("is held by tester"));
  EXPECT_FALSE(told.stopped);
}

TEST_F(BreakOrdersTest, ItsOwnWordToTheTeamDoesNotStopItAnew) {
  msg::TeamStop stop;
  stop.robot = io.name;
  io.send(stop);
  // The first that stops it is the one that it tells of.
  stop.robot = "ganymede";
  io.send(stop);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.executive->held(); }));
  io.robot.tick();
  const auto stopped = io.tell_when([](const msg::Breaks& each) { return each.stopped; });
  EXPECT_EQ(stopped.break_robot, "ganymede");
}

}  // namespace
}  // namespace galilean::robot
