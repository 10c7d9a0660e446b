// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/order_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/orders/order_signer.h"
#include "tests/temporary_folder.h"

namespace galilean {
namespace {

using testing::HasSubstr;
using Kind = OrderRefusal::Kind;

constexpr const char* kTopic = "rt/team/command";
constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 1'800'000'000 * kSecond;

SigningKey make_key() {
  auto key = SigningKey::make();
  if (!key) throw std::runtime_error(key.error().message);
  return std::move(key).value();
}

TrustedKeys trust_in(const SigningKey& key) {
  auto keys = TrustedKeys::read("ed25519 " + key.verifying_key().text() + " anna", "team.keys");
  if (!keys) throw std::runtime_error(keys.error().message);
  return std::move(keys).value();
}

msg::Command resume() {
  msg::Command command;
  command.id = "1";
  command.author = "anna";
  command.targets = {"io", "ganymede"};
  command.kind = msg::Command_Constants::RESUME;
  return command;
}

/// A robot that has been up for an hour, and an operator whose clock shows the same.
class OrderCheckTest : public testing::Test {
 protected:
  [[nodiscard]] msg::Command signed_resume() {
    msg::Command command = resume();
    signer.sign(command, kTopic);
    return command;
  }
  /// Returns why the order is refused, or nothing if it is accepted.
  template <class M>
  [[nodiscard]] std::optional<OrderRefusal> refusal_of(const M& order,
                                                       const std::string& topic = kTopic) {
    const auto accepted = check.accept(order, topic, {robot_ns, uptime_ns});
    if (accepted) return std::nullopt;
    return accepted.error();
  }
  template <class M>
  void expect_refused(const M& order, Kind kind, const std::string& why) {
    const auto refusal = refusal_of(order);
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->kind, kind);
    EXPECT_THAT(refusal->why, HasSubstr(why));
  }

  const SigningKey key = make_key();
  std::int64_t operator_ns = kStart;
  std::int64_t robot_ns = kStart;
  std::int64_t uptime_ns = 3600 * kSecond;
  OrderSigner signer{key, [this] { return operator_ns; }};
  OrderCheck check{trust_in(key)};
};

TEST_F(OrderCheckTest, AcceptsAnOrderOnce) {
  const auto command = signed_resume();
  EXPECT_FALSE(refusal_of(command));
  expect_refused(command, Kind::kReplayed, "it has come before");
  EXPECT_FALSE(refusal_of(signed_resume()));
}

TEST_F(OrderCheckTest, AcceptsOrdersInAnyOrder) {
  const auto first = signed_resume(), second = signed_resume();
  EXPECT_LT(first.signature.number, second.signature.number);
  EXPECT_FALSE(refusal_of(second));
  EXPECT_FALSE(refusal_of(first));
}

TEST_F(OrderCheckTest, RefusesWhatIsNotSignedByATrustedKey) {
  constexpr const char* kWhy = "it is not signed by a key that this robot trusts";
  expect_refused(resume(), Kind::kUntrusted, kWhy);
  OrderSigner stranger(make_key(), [this] { return operator_ns; });
  msg::Command command = resume();
  stranger.sign(command, kTopic);
  expect_refused(command, Kind::kUntrusted, kWhy);
  command.signature.key_id = signer.key_id();
  expect_refused(command, Kind::kBroken, "its signature does not fit it");
}

TEST_F(OrderCheckTest, RefusesWhateverWasChanged) {
  const auto whole = signed_resume();
  const std::function<void(msg::Command&)> changes[] = {
      [](auto& order) { order.id = "2"; },
      [](auto& order) { order.author = "ben"; },
      [](auto& order) { order.targets = {"io"}; },
      [](auto& order) { order.targets = {}; },
      [](auto& order) { order.kind = msg::Command_Constants::PUSH_BUMPER; },
      [](auto& order) { order.argument = 1; },
      [](auto& order) { order.stamp.sec += 1; },
      [](auto& order) { order.signature.number += 1; },
      [](auto& order) { order.signature.issued_ns += 1; },
      [](auto& order) { order.signature.expires_ns += 1; },
      [](auto& order) { order.signature.bytes[0] ^= 1; },
      [](auto& order) { order.signature.bytes.pop_back(); },
      [](auto& order) { order.signature.bytes.clear(); }};
  for (const auto& change : changes) {
    msg::Command order = whole;
    change(order);
    expect_refused(order, Kind::kBroken, "its signature does not fit it");
  }
  const auto elsewhere = refusal_of(whole, "rt/team/other");
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ(elsewhere->kind, Kind::kBroken);
  EXPECT_FALSE(refusal_of(whole));  // what was refused has not used its number up
}

TEST_F(OrderCheckTest, RefusesWhatIsExpiredButForTheTolerance) {
  const auto command = signed_resume();
  const std::int64_t last_ns =
      kStart + (OrderSigner::kLifetime + OrderCheck::kClockTolerance).count();
  robot_ns = last_ns;
  expect_refused(command, Kind::kExpired, "it expired 5 s ago");
  robot_ns = last_ns - 1;
  EXPECT_FALSE(refusal_of(command));
}

TEST_F(OrderCheckTest, RefusesWhatIsOfTheFutureButForTheTolerance) {
  operator_ns = kStart + OrderCheck::kClockTolerance.count() + 1;
  expect_refused(signed_resume(), Kind::kEarly, "it was signed 5 s after this robot's time");
  operator_ns -= 1;
  EXPECT_FALSE(refusal_of(signed_resume()));
}

TEST_F(OrderCheckTest, RefusesWhatWasSignedBeforeItStarted) {
  const auto command = signed_resume();
  robot_ns = kStart + kSecond;
  uptime_ns = kSecond - 1;
  expect_refused(command, Kind::kOfBefore, "it was signed before this robot started");
}

TEST_F(OrderCheckTest, AClockThatIsSetBackLetsNothingComeTwice) {
  const auto command = signed_resume();
  EXPECT_FALSE(refusal_of(command));
  robot_ns -= 3 * kSecond;
  expect_refused(command, Kind::kReplayed, "it has come before");
  operator_ns -= kSecond;  // the numbers rise all the same
  EXPECT_FALSE(refusal_of(signed_resume()));
}

/// Somebody captured the order, and the robot's clock comes to its time a second time.
TEST_F(OrderCheckTest, AClockThatIsSetBackOverARestartLetsNothingComeTwice) {
  const auto captured = signed_resume();
  EXPECT_FALSE(refusal_of(captured));
  OrderCheck again{trust_in(key), check.numbers()};
  EXPECT_EQ(again.numbers(), check.numbers());
  const auto refused = again.accept(captured, kTopic, {robot_ns, uptime_ns});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Kind::kOfBefore);
  EXPECT_THAT(refused.error().why, HasSubstr("before it was started again"));
  OrderCheck forgetful{trust_in(key)};
  EXPECT_TRUE(forgetful.accept(captured, kTopic, {robot_ns, uptime_ns})) << "this is what it keeps";
  EXPECT_TRUE(again.accept(signed_resume(), kTopic, {robot_ns, uptime_ns}));
}

TEST_F(OrderCheckTest, AnOlderOrderThatArrivesLateLowersNothing) {
  const auto first = signed_resume(), second = signed_resume();
  EXPECT_FALSE(refusal_of(second));
  EXPECT_FALSE(refusal_of(first));
  EXPECT_EQ(check.numbers().at(signer.key_id()), second.signature.number);
}

TEST_F(OrderCheckTest, WhatIsRefusedMovesNoNumber) {
  auto forged = signed_resume();
  forged.signature.number = UINT64_MAX;
  EXPECT_TRUE(refusal_of(forged));
  EXPECT_TRUE(check.numbers().empty());
}

TEST_F(OrderCheckTest, EachKeyHasNumbersOfItsOwn) {
  const SigningKey bens = make_key();
  const auto both = TrustedKeys::read("ed25519 " + key.verifying_key().text() + " anna\ned25519 " +
                                          bens.verifying_key().text() + " ben",
                                      "team.keys");
  ASSERT_TRUE(both) << both.error().message;
  OrderCheck trusting(both.value());
  OrderSigner ben(bens, [this] { return operator_ns; });
  msg::Command of_ben = resume();
  ben.sign(of_ben, kTopic);
  const auto of_anna = signed_resume();
  EXPECT_EQ(of_ben.signature.number, of_anna.signature.number) << "their clocks show the same";
  EXPECT_TRUE(trusting.accept(of_anna, kTopic, {robot_ns, uptime_ns}));
  EXPECT_TRUE(trusting.accept(of_ben, kTopic, {robot_ns, uptime_ns}));
  EXPECT_FALSE(trusting.accept(of_ben, kTopic, {robot_ns, uptime_ns}));
  auto stolen = of_ben;
  stolen.signature.key_id = signer.key_id();
  EXPECT_FALSE(trusting.accept(stolen, kTopic, {robot_ns, uptime_ns}));
}

/// Both machines had a wrong clock, which was set right, and both were started again.
TEST_F(OrderCheckTest, ASignerThatIsStartedAgainGoesOnAboveItsNumbersOfBefore) {
  const TemporaryFolder folder;
  const auto numbers = number_file(folder / "operator.key");
  {
    OrderSigner before(
        key, [this] { return operator_ns; }, numbers);
    msg::Command command = resume();
    before.sign(command, kTopic);
    EXPECT_FALSE(refusal_of(command));
  }
  constexpr std::int64_t kHour = 3600 * kSecond;
  operator_ns -= kHour;
  OrderCheck robot_again{trust_in(key), check.numbers()};
  OrderSigner again(
      key, [this] { return operator_ns; }, numbers);
  msg::Command command = resume();
  again.sign(command, kTopic);
  EXPECT_TRUE(robot_again.accept(command, kTopic, {operator_ns, uptime_ns}));
  OrderSigner without(key, [this] { return operator_ns; });
  without.sign(command, kTopic);
  EXPECT_FALSE(robot_again.accept(command, kTopic, {operator_ns, uptime_ns}));
}

TEST_F(OrderCheckTest, AnHourOfDifferenceIsSaidOnEitherSideAndEndsWithIt) {
  constexpr std::int64_t kHour = 3600 * kSecond;
  operator_ns = kStart + kHour;
  expect_refused(signed_resume(), Kind::kEarly, "3600 s after this robot's time; set the clocks");
  operator_ns = kStart - kHour;
  expect_refused(signed_resume(), Kind::kExpired, "set the clocks of both machines");
  operator_ns = kStart;
  EXPECT_FALSE(refusal_of(signed_resume()));
  robot_ns = kStart + kHour;  // the robot's clock is set forward while it runs
  expect_refused(signed_resume(), Kind::kExpired, "set the clocks of both machines");
  operator_ns = robot_ns;
  EXPECT_FALSE(refusal_of(signed_resume()));
  robot_ns = operator_ns = kStart;  // and back
  EXPECT_FALSE(refusal_of(signed_resume()));
}

TEST_F(OrderCheckTest, AnyTimesAreSurvived) {
  for (const std::int64_t wild : {INT64_MIN, INT64_MIN + 1, std::int64_t{0}, INT64_MAX}) {
    auto command = signed_resume();
    command.signature.issued_ns = wild;
    EXPECT_TRUE(refusal_of(command));
    command = signed_resume();
    command.signature.expires_ns = wild;
    EXPECT_TRUE(refusal_of(command));
  }
}

TEST_F(OrderCheckTest, EachKindOfOrderIsSigned) {
  msg::ProgramPush push;
  push.files = {{"a.bhdl", "text"}};
  signer.sign(push, "rt/team/program_push");
  EXPECT_FALSE(refusal_of(push, "rt/team/program_push"));
  signer.sign(push, "rt/team/program_push");
  push.files[0].text = "another";
  EXPECT_TRUE(refusal_of(push, "rt/team/program_push"));
  msg::ProgramRollback rollback;
  signer.sign(rollback, "rt/team/program_rollback");
  EXPECT_FALSE(refusal_of(rollback, "rt/team/program_rollback"));
  msg::BreakOrder order;
  order.points = {{"", "grab", 1}};
  signer.sign(order, "rt/team/break_order");
  EXPECT_FALSE(refusal_of(order, "rt/team/break_order"));
}

}  // namespace
}  // namespace galilean
