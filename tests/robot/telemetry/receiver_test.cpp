#include <gmock/gmock.h>

#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace status = msg::ProgramReply_Constants;

std::function<bool(const msg::ProgramReply&)> has_status(std::uint8_t wanted) {
  return [wanted](const msg::ProgramReply& reply) { return reply.status == wanted; };
}

std::string renamed(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

class ReceiverTest : public testing::Test {
 protected:
  ReceiverTest()
      : io(std::string("r_") + testing::UnitTest::GetInstance()->current_test_info()->name()),
        replies(*io.other, wire::robot_topic(io.name, "program_reply")) {
    EXPECT_TRUE(io.robot.load(kWaits));
    io.robot.tick(3);
    // Answered only when the publisher has seen the first program.
    auto programs = io.mailbox<msg::Program>("program");
    EXPECT_TRUE(programs.wait());
  }
  /// Ticks until the receiver has loaded a program, and that has had its first tick.
  void let_it_swap() {
    const auto before = io.robot.events.count(Event::Kind::kSwapped);
    EXPECT_TRUE(
        io.tick_until([&] { return io.robot.events.count(Event::Kind::kSwapped) > before; }));
  }
  std::string running_hash() const { return io.robot.executive->program()->text().hash; }

  TelemetryRobot io;
  Mailbox<msg::ProgramReply> replies;
};

TEST_F(ReceiverTest, AGoodProgramRunsAndProvesItself) {
  const auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  io.send(push);
  ASSERT_TRUE(replies.wait_for(has_status(status::RECEIVED)));
  let_it_swap();
  const auto running = replies.wait_for(has_status(status::RUNNING));
  ASSERT_TRUE(running);
  EXPECT_EQ(running->id, push.id);
  EXPECT_EQ(running->hash, push.hash);
  EXPECT_EQ(running->running_hash, push.hash);
  EXPECT_EQ(running->tick, io.robot.events.last(Event::Kind::kSwapped)->tick);
  EXPECT_THAT(running->kept_variables, ElementsAre("trash", "bumpers"));
  io.robot.tick(201);
  EXPECT_TRUE(replies.wait_for(has_status(status::CONFIRMED)));
  EXPECT_EQ(running_hash(), push.hash);
}

TEST_F(ReceiverTest, ABrokenProgramChangesNothingAndShowsEveryError) {
  const std::string before = running_hash();
  io.send(io.push(renamed(renamed(kWaits, "ahead", "ahaed"), "bit_value: 1", "bit_value: 7")));
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->running_hash, before);
  EXPECT_GE(rejected->diagnostics.size(), 2U);
  EXPECT_EQ(rejected->diagnostics[0].file, "test.bhdl");
  EXPECT_GT(rejected->diagnostics[0].line, 0U);
  io.robot.tick(3);
  EXPECT_EQ(running_hash(), before);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kSwapped), 0);
}

TEST_F(ReceiverTest, AProgramThatFailsIsRolledBackAndSaysWhy) {
  const std::string before = running_hash();
  const auto push = io.push(renamed(kWaits,
                                    "write_all: name: \"see\" locate_variable: \"trash\" "
                                    "certainty: 0.75",
                                    "thrower: name: \"see\" after: 2"));
  io.send(push);
  let_it_swap();
  io.robot.tick(5);
  const auto back = replies.wait_for(has_status(status::ROLLED_BACK));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->hash, push.hash);
  EXPECT_EQ(back->running_hash, before);
  EXPECT_EQ(back->message, "schema 'see' threw: the lens broke");
}

TEST_F(ReceiverTest, RefusesWhatWasChangedOnTheWay) {
  auto push = io.push(kWaits);
  push.files[0].text += "; more";
  io.send(push);
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_THAT(rejected->message, HasSubstr("changed on the way"));
}

TEST_F(ReceiverTest, RefusesToReplaceWhatDoesNotRun) {
  auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  push.replaces_hash = "0123";
  io.send(push);
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_THAT(rejected->message, HasSubstr("0123"));
}

TEST_F(ReceiverTest, WhatRunsAlreadyRunsOn) {
  io.send(io.push(kWaits));
  EXPECT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  EXPECT_TRUE(replies.wait_for(has_status(status::CONFIRMED)));
  io.robot.tick(3);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kSwapped), 0);
}

TEST_F(ReceiverTest, AnothersPushAndCommandAreNoneOfItsBusiness) {
  auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  push.targets = {"ganymede"};
  io.send(push);
  io.send(msg::Command_Constants::PUSH_BUMPER, 2, "ganymede");
  // What is meant for it comes after, on the same topic.
  push = io.push(kWaits + std::string("; this one"));
  io.send(push);
  let_it_swap();
  EXPECT_EQ(running_hash(), push.hash);
  EXPECT_EQ(io.robot.state(), "wait");
}

TEST_F(ReceiverTest, ObeysOperators) {
  io.send(msg::Command_Constants::PUSH_BUMPER, 2, io.name);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.state() == "go"; }));
  EXPECT_TRUE(io.robot.drive.moving);
  io.send(msg::Command_Constants::HOLD, 0, io.name);
  EXPECT_TRUE(io.tick_until([&] { return !io.robot.drive.moving; }));
  io.send(msg::Command_Constants::RESUME, 0, io.name);
  EXPECT_TRUE(io.tick_until([&] { return io.robot.drive.moving; }));
}

}  // namespace
}  // namespace galilean::robot
