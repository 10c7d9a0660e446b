// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/order_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/orders/order_signer.h"

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
