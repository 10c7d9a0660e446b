// SPDX-License-Identifier: BSD-3-Clause
// A robot that trusts one key, over DDS: who may move it, and who may stop it.
#include <gmock/gmock.h>

#include "core/orders/order_signer.h"
#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;
namespace kinds = msg::Command_Constants;
namespace status = msg::ProgramReply_Constants;

SigningKey some_key() {
  auto key = SigningKey::make();
  if (!key) throw std::runtime_error(key.error().message);
  return std::move(key).value();
}

TrustedKeys trust_of(const SigningKey& key) {
  auto keys = TrustedKeys::read("ed25519 " + key.verifying_key().text() + " anna", "team.keys");
  if (!keys) throw std::runtime_error(keys.error().message);
  return std::move(keys).value();
}

std::string place(const std::string& topic) {
  return order_place(static_cast<std::uint32_t>(kDomain), topic);
}

class SignedOrdersTest : public testing::Test {
 protected:
  SignedOrdersTest()
      : io(std::string("s_") + testing::UnitTest::GetInstance()->current_test_info()->name(),
           test_components(), trust_of(key)),
        states(io.mailbox<msg::RobotState>("state")),
        breaks(io.mailbox<msg::Breaks>("breaks")),
        replies(io.mailbox<msg::ProgramReply>("program_reply")) {
    EXPECT_TRUE(io.robot.load(kWaits));
    io.robot.tick(3);
  }
  [[nodiscard]] msg::Command command(std::uint8_t kind) {
    msg::Command message;
    message.id = "order " + std::to_string(++given);
    message.author = "anna";
    message.targets = {io.name};
    message.kind = kind;
    return message;
  }
  void send_signed(msg::Command message) {
    signer.sign(message, place(wire::kCommandTopic));
    io.send(message);
  }
  bool is_held_within_ticks(bool held) {
    return io.tick_until([&] { return (io.robot.events.standstill.hold != Hold::kNone) == held; });
  }
  /// Returns what the robot answers to an order that it refuses.
  std::string refusal_of(const std::string& id) {
    const auto told = breaks.wait_for([&](const msg::Breaks& each) {
      return !each.answers.empty() && each.answers.back().id == id;
    });
    return told ? told->answers.back().refused : "it answered nothing";
  }
  /// Ticks until the robot tells of a problem with this text.
  bool tells_of(const std::string& text) {
    const auto has_it = [&](const msg::RobotState& state) {
      return std::ranges::any_of(state.problems, [&](const std::string& problem) {
        return problem.find(text) != std::string::npos;
      });
    };
    return io.tick_until([&] { return std::ranges::any_of(states.all(), has_it); });
  }

  const SigningKey key = some_key();
  TelemetryRobot io;
  OrderSigner signer{key};
  Mailbox<msg::RobotState> states;
  Mailbox<msg::Breaks> breaks;
  Mailbox<msg::ProgramReply> replies;
  int given = 0;
};

TEST_F(SignedOrdersTest, AnybodyHoldsItAndOnlyATrustedKeyResumesIt) {
  io.send(command(kinds::HOLD));
  ASSERT_TRUE(is_held_within_ticks(true));
  const auto unsigned_resume = command(kinds::RESUME);
  io.send(unsigned_resume);
  EXPECT_THAT(refusal_of(unsigned_resume.id), HasSubstr("--key FILE"));
  EXPECT_TRUE(
      tells_of("A resume by 'monitor' was refused: it is not signed by a key that this "
               "robot trusts."));
  io.robot.tick(3);
  EXPECT_EQ(io.robot.events.standstill.hold, Hold::kOperator);
  send_signed(command(kinds::RESUME));
  EXPECT_TRUE(is_held_within_ticks(false));
}

TEST_F(SignedOrdersTest, AnOrderThatIsSentAgainDoesNothing) {
  auto resume = command(kinds::RESUME);
  signer.sign(resume, place(wire::kCommandTopic));
  io.send(resume);
  io.send(command(kinds::HOLD));
  ASSERT_TRUE(is_held_within_ticks(true));
  io.send(resume);
  EXPECT_TRUE(tells_of("it has come before"));
  io.robot.tick(3);
  EXPECT_EQ(io.robot.events.standstill.hold, Hold::kOperator);
}

TEST_F(SignedOrdersTest, WhatWasOrderedInAnotherDomainDoesNothingHere) {
  io.send(command(kinds::HOLD));
  ASSERT_TRUE(is_held_within_ticks(true));
  auto resume = command(kinds::RESUME);
  signer.sign(resume, order_place(static_cast<std::uint32_t>(kDomain) + 1, wire::kCommandTopic));
  io.send(resume);
  EXPECT_THAT(refusal_of(resume.id), HasSubstr("or is for another DDS domain"));
  io.robot.tick(3);
  EXPECT_EQ(io.robot.events.standstill.hold, Hold::kOperator);
}

TEST_F(SignedOrdersTest, OnlyAPushThatIsSignedRuns) {
  auto push = io.push(std::string(kWaits) + "\n");
  push.id = "unsigned";
  io.send(push);
  const auto rejected =
      replies.wait_for([](const msg::ProgramReply& reply) { return reply.id == "unsigned"; });
  ASSERT_TRUE(rejected);
  EXPECT_EQ(rejected->status, status::REJECTED);
  EXPECT_THAT(rejected->message, HasSubstr("not signed by a key that this robot trusts"));
  push.id = "signed";
  signer.sign(push, place(wire::kProgramPushTopic));
  io.send(push);
  EXPECT_TRUE(io.tick_until([&] {
    return std::ranges::any_of(replies.all(), [](const msg::ProgramReply& reply) {
      return reply.id == "signed" && reply.status == status::RUNNING;
    });
  }));
}

TEST_F(SignedOrdersTest, AStrangerWhoSendsAPushFirstDoesNotSpoilItsAnswer) {
  auto push = io.push(std::string(kWaits) + "\n");
  io.send(push);
  ASSERT_TRUE(replies.wait_for(
      [](const msg::ProgramReply& reply) { return reply.status == status::REJECTED; }));
  signer.sign(push, place(wire::kProgramPushTopic));
  io.send(push);
  EXPECT_TRUE(io.tick_until([&] {
    return std::ranges::any_of(replies.all(), [](const msg::ProgramReply& reply) {
      return reply.status == status::RUNNING;
    });
  }));
}

TEST_F(SignedOrdersTest, AStrangerWhoCopiesAPushDoesNotSpoilItsAnswer) {
  auto push = io.push(std::string(kWaits) + "\n");
  signer.sign(push, place(wire::kProgramPushTopic));
  io.send(push);
  ASSERT_TRUE(io.tick_until([&] {
    return std::ranges::any_of(replies.all(), [](const msg::ProgramReply& reply) {
      return reply.status == status::RUNNING;
    });
  }));
  push.signature = {};
  io.send(push);
  EXPECT_TRUE(tells_of("A push of program"));
  EXPECT_FALSE(std::ranges::any_of(replies.all(), [](const msg::ProgramReply& reply) {
    return reply.status == status::REJECTED;
  }));
}

TEST_F(SignedOrdersTest, AFloodOfAStrangersOrdersHidesNoAnswer) {
  auto step = command(kinds::STEP);
  step.id = "true step";
  io.send(command(kinds::HOLD));
  ASSERT_TRUE(is_held_within_ticks(true));
  signer.sign(step, place(wire::kCommandTopic));
  io.send(step);
  const auto has_answer = [](const msg::Breaks& told, const std::string& id) {
    return std::ranges::any_of(told.answers, [&](const auto& each) { return each.id == id; });
  };
  ASSERT_TRUE(
      breaks.wait_for([&](const msg::Breaks& each) { return has_answer(each, "true step"); }));
  constexpr std::size_t kFlood = 3 * BreakDesk::kAnswersKept;
  for (std::size_t i = 1; i <= kFlood; ++i) {
    auto resume = command(kinds::RESUME);
    resume.id = "flood " + std::to_string(i);
    io.send(resume);
  }
  const auto told = breaks.wait_for(
      [&](const msg::Breaks& each) { return has_answer(each, "flood " + std::to_string(kFlood)); });
  ASSERT_TRUE(told);
  EXPECT_TRUE(has_answer(*told, "true step"));
  EXPECT_LE(told->answers.size(), BreakDesk::kAnswersKept);
}

TEST_F(SignedOrdersTest, AnybodySetsABreakPointAndOnlyATrustedKeyRemovesIt) {
  const auto told_of = [&](const std::string& id) {
    return breaks.wait_for([&](const msg::Breaks& each) {
      return !each.answers.empty() && each.answers.back().id == id;
    });
  };
  msg::BreakOrder order;
  order.id = "set";
  order.author = "a stranger";
  order.targets = {io.name};
  order.order = "set";
  order.points = {{"wait", "go", msg::BreakPoint_Constants::STOP}};
  io.send(order);
  const auto set = told_of("set");
  ASSERT_TRUE(set);
  EXPECT_EQ(set->points.size(), 1U);
  order.id = "lock";
  order.points = {{"go", "", msg::BreakPoint_Constants::LOCK}};
  io.send(order);
  EXPECT_THAT(refusal_of("lock"), HasSubstr("it is not signed by a key that this robot trusts"));
  order.points = {{"wait", "go", msg::BreakPoint_Constants::STOP}};
  order.id = "remove";
  order.order = "remove";
  io.send(order);
  EXPECT_THAT(refusal_of("remove"), HasSubstr("it is not signed by a key that this robot trusts"));
  order.id = "signed remove";
  signer.sign(order, place(wire::kBreakOrderTopic));
  io.send(order);
  const auto removed = told_of("signed remove");
  ASSERT_TRUE(removed);
  EXPECT_TRUE(removed->points.empty());
}

}  // namespace
}  // namespace galilean::robot
