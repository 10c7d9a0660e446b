// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/break_options.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace points = msg::BreakPoint_Constants;

/// Reads a command line of `galilean break`. The test fails if it is refused.
BreakOptions read(std::vector<const char*> arguments) {
  BreakOptions options;
  CommandLine line("Breaks.", "galilean break");
  add_break_options(line, options);
  arguments.insert(arguments.begin(), "galilean-break");
  EXPECT_EQ(line.parse(static_cast<int>(arguments.size()), arguments.data()), std::nullopt);
  return options;
}

int refusal_of(std::vector<const char*> arguments) {
  BreakOptions options;
  CommandLine line("Breaks.", "galilean break");
  add_break_options(line, options);
  arguments.insert(arguments.begin(), "galilean-break");
  testing::internal::CaptureStderr();
  const auto code = line.parse(static_cast<int>(arguments.size()), arguments.data());
  EXPECT_NE(testing::internal::GetCapturedStderr(), "");
  return code.value_or(0);
}

TEST(BreakOptions, PlacesMakeAnOrderToSetThem) {
  const auto options = read({"grab", "wander:rest", "--robot", "io", "ganymede"});
  EXPECT_THAT(options.whom.robots, ElementsAre("io", "ganymede"));
  const auto order = order_of(options).value();
  EXPECT_EQ(order.order, "set");
  EXPECT_THAT(order.points, ElementsAre(msg::BreakPoint{"", "grab", points::STOP},
                                        msg::BreakPoint{"wander", "rest", points::STOP}));
}

TEST(BreakOptions, FlagsChooseTheKindAndTheOrder) {
  EXPECT_EQ(order_of(read({"grab", "--lock", "--team"})).value().points[0].kind, points::LOCK);
  EXPECT_EQ(order_of(read({"grab", "--stop-team", "--team"})).value().points[0].kind,
            points::STOP_TEAM);
  EXPECT_EQ(order_of(read({"grab", "--remove", "--team"})).value().order, "remove");
  EXPECT_EQ(order_of(read({"--clear", "--team"})).value().order, "clear");
  const auto order = order_of(read({"--let-through", "wander:grab", "--team"})).value();
  EXPECT_EQ(order.order, "let_through");
  EXPECT_EQ(order.points[0].from_state, "wander");
  EXPECT_TRUE(read({"--list"}).list);
}

TEST(BreakOptions, WithoutAPlaceThereIsNoOrder) {
  EXPECT_THAT(order_of(read({})).error().message, HasSubstr("Name a state"));
  EXPECT_THAT(order_of(read({"--remove"})).error().message, HasSubstr("Name a state"));
  EXPECT_THAT(order_of(read({":"})).error().message, HasSubstr("names no state"));
}

TEST(BreakOptions, AnOrderThatNamesNobodyIsRefusedAndSaysWhatToType) {
  for (const auto& words : std::vector<std::vector<const char*>>{
           {"grab"}, {"grab", "--remove"}, {"--clear"}, {"--let-through", "wander:grab"}}) {
    const auto order = order_of(read(words));
    ASSERT_FALSE(order.ok()) << words[0];
    EXPECT_EQ(order.error().message, "Name the robots with --team or --robot NAME.");
  }
}

TEST(BreakOptions, WhatContradictsItselfIsRefused) {
  EXPECT_EQ(refusal_of({"grab", "--lock", "--stop-team"}), 2);
  EXPECT_EQ(refusal_of({"grab", "--clear"}), 2);
  EXPECT_EQ(refusal_of({"--clear", "--list"}), 2);
  EXPECT_EQ(refusal_of({"--list", "--let-through", "a:b"}), 2);
  EXPECT_EQ(refusal_of({"grab", "--remove", "--lock"}), 2);
  EXPECT_EQ(refusal_of({"grab", "--team", "--robot", "io"}), 2);
}

}  // namespace
}  // namespace galilean::monitor
