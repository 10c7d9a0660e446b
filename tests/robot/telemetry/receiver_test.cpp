// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "robot/executive/opened_devices.h"
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

TEST_F(ReceiverTest, OnlyAProgramThatHasProvenItselfIsKeptForAStartAfterACrash) {
  using Kept = std::pair<std::string, bool>;
  const std::string first = running_hash();
  const auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  io.send(push);
  let_it_swap();
  ASSERT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  EXPECT_THAT(io.kept(), ElementsAre());
  io.robot.tick(201);
  ASSERT_TRUE(replies.wait_for(has_status(status::CONFIRMED)));
  EXPECT_THAT(io.kept(), ElementsAre(Kept(push.hash, true)));
  msg::ProgramRollback order;
  order.id = "back";
  order.author = "tester";
  order.targets = {io.name};
  order.hash = push.hash;
  io.send(order);
  EXPECT_TRUE(io.tick_until([&] { return io.robot.events.count(Event::Kind::kRolledBack) == 1; }));
  ASSERT_TRUE(replies.wait_for(has_status(status::ROLLED_BACK)));
  EXPECT_THAT(io.kept(), ElementsAre(Kept(push.hash, true), Kept(first, false)));
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

TEST_F(ReceiverTest, APushThatItFailsOnIsRejectedAndTheNextOneRuns) {
  io.robot.on_waiting = [this] {
    io.robot.on_waiting = [] {};
    throw std::runtime_error("no room");
  };
  io.send(io.push(renamed(kWaits, "\"go\"", "\"move\"")));
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->message, "this robot could not handle it: no room");
  const auto next = io.push(renamed(kWaits, "\"go\"", "\"run\""));
  io.send(next);
  EXPECT_TRUE(io.tick_until([&] {
    return std::ranges::any_of(replies.all(), [&](const msg::ProgramReply& reply) {
      return reply.status == status::RUNNING && reply.hash == next.hash;
    });
  }));
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

TEST_F(ReceiverTest, AProgramIsTakenOffOnOrder) {
  const std::string before = running_hash();
  auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  push.probation_s = 3600;  // longer than the robot can tick until the order arrives
  io.send(push);
  let_it_swap();
  ASSERT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  msg::ProgramRollback order;
  order.id = "order";
  order.author = "anna";
  order.hash = push.hash;
  order.reason = "it circles";
  io.send(order);
  ASSERT_TRUE(io.tick_until([&] { return running_hash() == before; }));
  for (const std::string& id : {push.id, order.id}) {
    const auto back = replies.wait_for([&](const msg::ProgramReply& reply) {
      return reply.status == status::ROLLED_BACK && reply.id == id;
    });
    ASSERT_TRUE(back) << id;
    EXPECT_EQ(back->running_hash, before);
    EXPECT_EQ(back->message, "ordered by anna: it circles");
  }
}

TEST_F(ReceiverTest, APushThatAnOrderBringsBackProvesItselfAfterAll) {
  auto first = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  auto second = io.push(renamed(kWaits, "\"go\"", "\"run\""));
  first.probation_s = second.probation_s = 3600;  // longer than the robot can tick meanwhile
  second.id = "second";
  for (const auto& push : {first, second}) {
    io.send(push);
    ASSERT_TRUE(io.tick_until([&] { return running_hash() == push.hash; }));
  }
  msg::ProgramRollback order;
  order.id = "order";
  order.hash = second.hash;
  io.send(order);
  ASSERT_TRUE(io.tick_until([&] { return running_hash() == first.hash; }));
  io.robot.tick(3600 * 20 + 1);
  const auto proven = replies.wait_for(has_status(status::CONFIRMED));
  ASSERT_TRUE(proven);
  EXPECT_EQ(proven->id, first.id);
}

TEST_F(ReceiverTest, RefusesToTakeOffWhatDoesNotRunOrHasNoPredecessor) {
  msg::ProgramRollback order;
  order.id = "stale";
  order.hash = "0123";
  io.send(order);
  const auto stale = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(stale);
  EXPECT_THAT(stale->message, HasSubstr(running_hash()));
  order.id = "first";
  order.hash = running_hash();
  io.send(order);
  const auto first =
      replies.wait_for([](const msg::ProgramReply& reply) { return reply.id == "first"; });
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, status::REJECTED);
  EXPECT_THAT(first->message, HasSubstr("no program ran before"));
}

TEST_F(ReceiverTest, APushBringsItsOwnProbation) {
  auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  push.probation_s = 0.5;
  io.send(push);
  let_it_swap();
  EXPECT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  io.robot.tick(11);
  EXPECT_TRUE(replies.wait_for(has_status(status::CONFIRMED)));
  push.id = "endless";
  push.files[0].text += ";";
  push.hash = bhdl::program_hash({{push.files[0].path, push.files[0].text}});
  push.probation_s = 3602;  // of a canary for an hour, until its monitor has decided
  io.send(push);
  EXPECT_TRUE(io.tick_until([&] { return running_hash() == push.hash; }));
  push.id = "none";
  push.files[0].text += ";";
  push.hash = bhdl::program_hash({{push.files[0].path, push.files[0].text}});
  push.probation_s = std::numeric_limits<float>::quiet_NaN();
  io.send(push);
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_THAT(rejected->message, HasSubstr("probation"));
}

TEST_F(ReceiverTest, ARobotThatLosesEverybodyRunsOn) {
  io.robot.press(2);
  io.robot.tick();
  ASSERT_EQ(io.robot.state(), "go");
  const std::string before = running_hash();
  io.send(io.push(renamed(kWaits, "\"wait\"", "\"rest\"")));
  let_it_swap();
  io.telemetry.reset();
  io.participant.reset();
  io.robot.tick(1000);
  EXPECT_EQ(io.robot.state(), "go");
  EXPECT_TRUE(io.robot.drive.moving);
  EXPECT_NE(running_hash(), before);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kConfirmed), 1) << "probation goes on alone";
  EXPECT_EQ(io.robot.events.count(Event::Kind::kRolledBack), 0);
}

TEST_F(ReceiverTest, RefusesProgramsOfStrangersAndObeysTheirCommands) {
  const std::string before = running_hash();
  auto logs = Mailbox<msg::Log>(*io.other, wire::kLogTopic);
  const auto stranger = wire::Participant::join("swap", kDomain);
  wire::Writer<msg::ProgramPush> pushes(*stranger.value(), wire::kProgramPushTopic);
  wire::Writer<msg::ProgramRollback> orders(*stranger.value(), wire::kProgramRollbackTopic);
  wire::Writer<msg::Command> commands(*stranger.value(), wire::kCommandTopic);
  while (pushes.readers() + orders.readers() + commands.readers() < 3) std::this_thread::yield();

  auto push = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  push.author = "the monitor, honestly";
  ASSERT_TRUE(pushes.write(push));
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->id, push.id);
  EXPECT_THAT(rejected->message, HasSubstr("'swap'"));
  EXPECT_THAT(rejected->message, HasSubstr("--accept-swaps-from"));
  EXPECT_TRUE(logs.wait_for([&](const msg::Log& line) {
    return line.name == io.name && line.msg.find("'swap'") != std::string::npos;
  }));

  msg::ProgramRollback order;
  order.id = "order";
  order.hash = before;
  ASSERT_TRUE(orders.write(order));
  const auto refused =
      replies.wait_for([](const msg::ProgramReply& reply) { return reply.id == "order"; });
  ASSERT_TRUE(refused);
  EXPECT_THAT(refused->message, HasSubstr("'swap'"));

  msg::Command hold;
  hold.targets = {io.name};
  hold.kind = msg::Command_Constants::HOLD;
  ASSERT_TRUE(commands.write(hold));
  EXPECT_TRUE(io.tick_until([&] { return io.robot.executive->held(); }));
  EXPECT_EQ(running_hash(), before);
}

TEST(AcceptedSenders, AreTheMonitorOrThoseThatAreNamedOrAny) {
  EXPECT_TRUE(AcceptedSenders().accept(wire::kMonitorName));
  EXPECT_FALSE(AcceptedSenders().accept("swap"));
  EXPECT_FALSE(AcceptedSenders().accept(std::nullopt));
  const AcceptedSenders two({"swap", "page"});
  EXPECT_TRUE(two.accept("page"));
  EXPECT_THAT(two.accept(wire::kMonitorName).error().message, HasSubstr("swap, page"));
  EXPECT_TRUE(AcceptedSenders({AcceptedSenders::kAny}).accept(std::nullopt));
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

TEST_F(ReceiverTest, RefusesAProgramForOtherDevicesAndRunsOn) {
  const std::string before = running_hash();
  const OpenedDevices opened{.serial = "/dev/ttyS0"};
  io.robot.admits = [opened](const bhdl::Program& program) {
    return opened.accept(program, test_components().catalog());
  };
  const std::string line = "input_devices: comm_port: device: \"/dev/ttyS1\" end end\n";
  io.send(io.push(line + kWaits));
  const auto rejected = replies.wait_for(has_status(status::REJECTED));
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->running_hash, before);
  EXPECT_EQ(rejected->message,
            "comm_port is '/dev/ttyS1' in this program, and this robot runs on '/dev/ttyS0': "
            "devices are opened when a robot starts, so restart it with this program");
  io.robot.tick(3);
  EXPECT_EQ(running_hash(), before);
}

TEST_F(ReceiverTest, WhatRunsAlreadyRunsOn) {
  io.send(io.push(kWaits));
  EXPECT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  EXPECT_TRUE(replies.wait_for(has_status(status::CONFIRMED)));
  io.robot.tick(3);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kSwapped), 0);
}

TEST_F(ReceiverTest, APushThatComesTwiceDoesNothingAndGetsTheFirstOnesAnswer) {
  const auto first = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  io.send(first);
  let_it_swap();
  auto second = io.push(renamed(kWaits, "\"go\"", "\"run\""));
  second.id = "the second";
  io.send(second);
  let_it_swap();
  ASSERT_EQ(running_hash(), second.hash);
  const auto answers = [&] {
    return std::ranges::count_if(replies.all(), [&](const msg::ProgramReply& reply) {
      return reply.id == first.id && reply.status > status::RECEIVED;
    });
  };
  ASSERT_TRUE(io.tick_until([&] { return answers() >= 1; }));
  const auto before = answers();
  io.send(first);
  EXPECT_TRUE(io.tick_until([&] { return answers() > before; }));
  io.robot.tick(3);
  EXPECT_EQ(running_hash(), second.hash);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kSwapped), 2);
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

TEST_F(ReceiverTest, ADecommissionedRobotStandsUntilItIsCommissioned) {
  io.robot.press(2);
  io.robot.tick();
  ASSERT_TRUE(io.robot.drive.moving);
  io.send(msg::Command_Constants::DECOMMISSION, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return !io.robot.drive.moving; }));
  io.send(msg::Command_Constants::HOLD, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.executive->held(); }));
  io.send(msg::Command_Constants::RESUME, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return !io.robot.executive->held(); }));
  io.robot.tick(5);
  EXPECT_EQ(io.robot.state(), "go");
  EXPECT_FALSE(io.robot.drive.moving);
  const auto push = io.push(kWaits + std::string("; another text"));
  io.send(push);
  ASSERT_TRUE(io.tick_until([&] { return running_hash() == push.hash; }));
  io.robot.tick(3);
  EXPECT_FALSE(io.robot.drive.moving) << "a new program does not put it into service";
  io.send(msg::Command_Constants::COMMISSION, 0, io.name);
  EXPECT_TRUE(io.tick_until([&] { return io.robot.drive.moving; }));
}

TEST_F(ReceiverTest, ADecommissionedRobotTakesOnlyAProgramThatNamesIt) {
  io.send(msg::Command_Constants::DECOMMISSION, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return !io.robot.executive->in_service(); }));
  auto to_all = io.push(renamed(kWaits, "\"go\"", "\"move\""));
  to_all.id = "to all";
  to_all.targets.clear();
  io.send(to_all);
  // What names it comes after, on the same topic.
  const auto to_it = io.push(renamed(kWaits, "\"go\"", "\"run\""));
  io.send(to_it);
  ASSERT_TRUE(io.tick_until([&] { return running_hash() == to_it.hash; }));
  ASSERT_TRUE(replies.wait_for(has_status(status::RUNNING)));
  for (const auto& reply : replies.all()) EXPECT_EQ(reply.id, to_it.id);
  EXPECT_EQ(io.robot.events.count(Event::Kind::kSwapped), 1);

  io.send(msg::Command_Constants::COMMISSION, 0, io.name);
  ASSERT_TRUE(io.tick_until([&] { return io.robot.executive->in_service(); }));
  to_all.id = "to all again";
  io.send(to_all);
  EXPECT_TRUE(io.tick_until([&] { return running_hash() == to_all.hash; }));
}

}  // namespace
}  // namespace galilean::robot
