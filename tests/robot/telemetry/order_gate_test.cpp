// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/order_gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/orders/order_signer.h"
#include "robot/telemetry/order_words.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kCommands = "rt/team/command";
constexpr std::int64_t kNow_ns = 1'800'000'000'000'000'000;

SigningKey made_key() {
  auto key = SigningKey::make();
  if (!key) throw std::runtime_error(key.error().message);
  return std::move(key).value();
}

TrustedKeys trusting(const SigningKey& key) {
  auto keys = TrustedKeys::read("ed25519 " + key.verifying_key().text(), "team.keys");
  if (!keys) throw std::runtime_error(keys.error().message);
  return std::move(keys).value();
}

msg::Command command_of(std::uint8_t kind) {
  msg::Command command;
  command.kind = kind;
  return command;
}

class OrderGateTest : public testing::Test {
 protected:
  /// Returns whether a resume of the sender with this writer is let through.
  bool let_through(std::uint64_t writer, const std::string& name, const std::string& address,
                   bool is_signed = false) {
    msg::Command command = command_of(msg::Command_Constants::RESUME);
    if (is_signed) signer.sign(command, kCommands);
    const auto who = [this, name, address] {
      ++looked_up;
      return std::optional(wire::Sender{name, address});
    };
    return gate.admit(command, kCommands, what_is(command), {writer, who}).ok();
  }
  /// Returns the sentences of all problems that the gate tells of.
  std::vector<std::string> sentences() {
    gate.on_round();
    std::vector<std::string> found;
    for (const auto& problem : problems.all()) found.push_back(problem.sentence);
    return found;
  }

  const SigningKey key = made_key();
  OrderSigner signer{key, [] { return kNow_ns; }};
  SteppedClock clock;
  ThreadProblems problems;
  OrderGate gate{trusting(key), clock, problems,
                 [] { return CheckTimes{.now_ns = kNow_ns, .uptime_ns = 1'000'000'000}; }};
  int looked_up = 0;
};

TEST_F(OrderGateTest, LetsWhatIsSignedThroughAndTellsOfNothing) {
  EXPECT_TRUE(let_through(1, "monitor", "192.168.1.7", true));
  EXPECT_THAT(sentences(), IsEmpty());
}

TEST_F(OrderGateTest, WithoutKeysAnybodyIsLetThrough) {
  OrderGate open(std::nullopt, clock, problems);
  EXPECT_TRUE(open.admit(command_of(msg::Command_Constants::RESUME), kCommands, "A resume", {}));
}

TEST_F(OrderGateTest, KeepsHowFarOrdersHaveComeAndRefusesThoseOfBefore) {
  const auto times = [] { return CheckTimes{.now_ns = kNow_ns, .uptime_ns = 1'000'000'000}; };
  msg::Command command = command_of(msg::Command_Constants::RESUME);
  signer.sign(command, kCommands);
  OrderNumbers kept;
  OrderGate first(trusting(key), clock, problems, times,
                  {.before = {}, .keep = [&kept](const OrderNumbers& now) { kept = now; }});
  EXPECT_FALSE(first.admit(command_of(msg::Command_Constants::STEP), kCommands, "A step", {}));
  EXPECT_TRUE(kept.empty());
  EXPECT_TRUE(first.admit(command, kCommands, "A resume", {}));
  EXPECT_EQ(kept, (OrderNumbers{{signer.key_id(), command.signature.number}}));
  OrderGate after(trusting(key), clock, problems, times, {.before = kept});
  const auto again = after.admit(command, kCommands, "A resume", {});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, OrderRefusal::Kind::kOfBefore);
}

TEST_F(OrderGateTest, SaysWhoseOrderWasRefusedAndWhy) {
  EXPECT_FALSE(let_through(1, "monitor", "192.168.1.7"));
  EXPECT_THAT(sentences(),
              testing::ElementsAre("A resume by 'monitor' (192.168.1.7) was refused: it is not "
                                   "signed by a key that this robot trusts."));
}

TEST_F(OrderGateTest, TellsOfASenderOnceAndThenEachTenfold) {
  std::vector<std::string> told;
  for (int order = 1; order <= 100; ++order) {
    EXPECT_FALSE(let_through(1, "monitor", "192.168.1.7"));
    for (auto& sentence : sentences())
      if (told.empty() || told.back() != sentence) told.push_back(sentence);
  }
  ASSERT_THAT(told, SizeIs(3));
  EXPECT_THAT(told[1], HasSubstr("So were 10 orders in all."));
  EXPECT_THAT(told[2], HasSubstr("So were 100 orders in all."));
  EXPECT_EQ(looked_up, 1);
}

TEST_F(OrderGateTest, ManySendersAreToldAsOne) {
  for (std::uint64_t writer = 1; writer <= 100; ++writer) {
    EXPECT_FALSE(let_through(writer, "robot" + std::to_string(writer), "10.0.0.1"));
    (void)sentences();
  }
  EXPECT_THAT(sentences(), SizeIs(OrderGate::kMostSenders + 1));
}

TEST_F(OrderGateTest, AFloodIsCountedWithoutNames) {
  for (std::size_t order = 0; order < OrderGate::kMostWaiting + 5; ++order)
    EXPECT_FALSE(let_through(order + 1, "robot", "10.0.0.1"));
  const auto found = sentences();
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_THAT(found, testing::Contains(HasSubstr("faster than their senders")));
}

TEST_F(OrderGateTest, AProblemEndsWhenNothingMoreIsRefused) {
  EXPECT_FALSE(let_through(1, "monitor", "192.168.1.7"));
  clock.advance(OrderGate::kForgetAfter - std::chrono::seconds(1));
  EXPECT_THAT(sentences(), SizeIs(1));
  clock.advance(OrderGate::kForgetAfter + std::chrono::seconds(1));
  EXPECT_THAT(sentences(), IsEmpty());
}

TEST_F(OrderGateTest, WhatASenderCallsItselfCannotForgeASentence) {
  EXPECT_FALSE(let_through(1, "m\nAll is well" + std::string(1000, 'x'), ""));
  const auto found = sentences();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0], HasSubstr("'mU+000AAll is well"));
  EXPECT_LT(found[0].size(), 200U);
}

TEST(OrderWords, WhatCanMoveARobotNeedsASignature) {
  namespace kinds = msg::Command_Constants;
  for (const std::uint8_t kind : {kinds::HOLD, kinds::DECOMMISSION})
    EXPECT_FALSE(can_move(command_of(kind))) << int{kind};
  for (const std::uint8_t kind : {kinds::RESUME, kinds::PUSH_BUMPER, kinds::COMMISSION, kinds::STEP,
                                  std::uint8_t{0}, std::uint8_t{99}})
    EXPECT_TRUE(can_move(command_of(kind))) << int{kind};
}

TEST(OrderWords, ABreakPointMoreStopsAndOneLessLetsGoOn) {
  msg::BreakOrder order;
  order.order = "set";
  order.points = {{"wander", "grab", msg::BreakPoint_Constants::STOP}};
  EXPECT_FALSE(can_move(order, {}));
  EXPECT_FALSE(can_move(order, {{{"rest", "wander"}, BreakKind::kLock}}));
  EXPECT_TRUE(can_move(order, {{{"wander", "grab"}, BreakKind::kLock}}));
  EXPECT_TRUE(can_move(order, {{{"", "grab"}, BreakKind::kLock}}));
  order.points[0].kind = msg::BreakPoint_Constants::STOP_TEAM;
  EXPECT_FALSE(can_move(order, {}));
  for (const std::string each : {"remove", "clear", "let_through", "nonsense"}) {
    order.order = each;
    EXPECT_TRUE(can_move(order, {})) << each;
  }
}

TEST(OrderWords, ALockNeedsASignatureBecauseTheRobotDrivesOn) {
  msg::BreakOrder order;
  order.order = "set";
  order.points = {{"wander", "grab", msg::BreakPoint_Constants::STOP}};
  for (const std::uint8_t kind :
       {msg::BreakPoint_Constants::LOCK, std::uint8_t{0}, std::uint8_t{99}}) {
    order.points.push_back({"", "rest", kind});
    EXPECT_TRUE(can_move(order, {})) << int{kind};
    order.points.pop_back();
  }
}

}  // namespace
}  // namespace galilean::robot
