// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/expression.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

bool holds(const char* text, const Expression::Newest& newest) {
  const auto expression = Expression::parse(text);
  EXPECT_TRUE(expression.ok()) << text;
  const auto held = expression.value().holds(newest);
  EXPECT_TRUE(held.ok()) << text;
  return held.value();
}

const Expression::Newest kNewest{
    {"io/state", {{"state", "wander"}, {"tick", 7}, {"held", false}}},
    {"referee/score", {{"deposited", 3}, {"calls", {{{"text", "goal or miss"}}}}}}};

TEST(Expression, ComparesFieldsWithValues) {
  EXPECT_TRUE(holds("io/state.state == \"wander\"", kNewest));
  EXPECT_TRUE(holds("/referee/score.deposited>=3", kNewest));
  EXPECT_TRUE(holds("referee/score.deposited < 3.5", kNewest));
  EXPECT_TRUE(holds("io/state.held == false", kNewest));
  EXPECT_TRUE(holds("referee/score.calls[0].text == \"goal or miss\"", kNewest));
  EXPECT_FALSE(holds("io/state.tick > 7", kNewest));
}

TEST(Expression, AndBindsTighterThanOr) {
  EXPECT_TRUE(holds("io/state.tick == 7 or io/state.tick == 8 and io/state.tick == 9", kNewest));
  EXPECT_FALSE(holds("io/state.tick == 8 and io/state.tick == 7", kNewest));
}

TEST(Expression, IsFalseWhileATopicIsSilentOrAListTooShort) {
  EXPECT_FALSE(holds("callisto/state.tick != 1", kNewest));
  EXPECT_FALSE(holds("referee/score.calls[5].text == \"\"", kNewest));
}

TEST(Expression, AMissingFieldIsAnErrorThatSaysWhatWasMeant) {
  const auto held = Expression::parse("io/state.stae == 1").value().holds(kNewest);
  ASSERT_FALSE(held.ok());
  EXPECT_NE(held.error().message.find("did you mean 'state'?"), std::string::npos);
}

TEST(Expression, WhatCanNeverBeTrueIsAnErrorThatSaysWhy) {
  const auto why = [](const char* text) {
    const auto held = Expression::parse(text).value().holds(kNewest);
    return held ? "no error" : held.error().message;
  };
  EXPECT_EQ(why("io/state.state == 3"),
            "/io/state: 'state' is a text, and is compared with a number, so that it can never be "
            "true");
  EXPECT_NE(why("io/state.tick == \"7\"").find("is a number, and is compared with a text"),
            std::string::npos);
  EXPECT_NE(why("io/state.held == 0").find("is true or false"), std::string::npos);
  EXPECT_NE(why("referee/score.calls == 0").find("is no single value"), std::string::npos);
}

TEST(Expression, RefusesWhatIsNone) {
  for (const char* text : {"", "io/state", "io/state.tick", "io/state.tick = 3",
                           "io/state.tick ==", "io/state.tick == wander", "io/state.tick == 3 and",
                           "io/state.tick == 3 io/state.tick == 3", "io/state.state == \"open"})
    EXPECT_FALSE(Expression::parse(text).ok()) << text;
}

}  // namespace
}  // namespace galilean::monitor
