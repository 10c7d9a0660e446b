// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace galilean::sim {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& text) {
  const auto scenario = scenario_from_json(text, "mine.json");
  return scenario ? "no error" : scenario.error().message;
}

std::string with(const std::string& fields) {
  return R"({"name": "mine", "arena": {"width_m": 5, "depth_m": 4},
             "robots": {"starts": [{"at": [2, 2]}]}, )" +
         fields + "}";
}

TEST(Scenario, EveryOneThatShipsMakesAWorldForEachOfTenSeeds) {
  ASSERT_THAT(shipped_scenarios(), testing::IsSupersetOf({"office", "practice", "empty"}));
  for (const auto& name : shipped_scenarios())
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const auto scenario = load_scenario(name);
      ASSERT_TRUE(scenario) << scenario.error().message;
      const auto world = World::make(scenario.value(), 3, seed);
      EXPECT_TRUE(world) << world.error().message;
    }
}

TEST(Scenario, OfficeHasTwentyFourPiecesAndTenMinutes) {
  const auto office = load_scenario("office");
  ASSERT_TRUE(office);
  EXPECT_EQ(World::make(office.value(), 3, 1).value()->objects().pieces().size(), 24U);
  EXPECT_EQ(office.value().rules.duration_s, 600);
}

TEST(Scenario, ErrorsNameFilePathAndWhatIsExpected) {
  EXPECT_EQ(error_of(R"({"name": "x", "arena": {"width_m": "wide", "depth_m": 2}})"),
            "mine.json: arena.width_m: expected a number from 1 to 60, found \"wide\"");
  EXPECT_EQ(error_of(R"({"name": "x", "arena": {"width_m": 4}})"),
            "mine.json: arena.depth_m: missing; expected a number");
  EXPECT_THAT(error_of(with(R"("chairs": [{"at": [1, 1]}, {"at": 3}])")),
              HasSubstr("chairs[1].at: expected a pair [x, y], found 3"));
  EXPECT_THAT(error_of(with(R"("rules": {"duration": 5})")),
              HasSubstr("rules.duration: unknown field; expected one of duration_s, "));
  EXPECT_THAT(error_of(with(R"("pieces": {"placed": [{"kind": "pen", "at": [1, 1]}]})")),
              HasSubstr("pieces.placed[0].kind: expected can, cup or wad, found \"pen\""));
  EXPECT_THAT(error_of(with(R"("baskets": [{"at": [9, 1]}])")),
              HasSubstr("baskets[0].at: stands outside the arena"));
  EXPECT_THAT(error_of(R"({"name": "x", "arena": {"width_m": 5, "depth_m": 4}})"),
              HasSubstr("robots.starts: expected at least one place"));
}

TEST(Scenario, WhatIsNoJsonIsOneLine) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[1]"),
                                  std::string("\0\xff\xfe", 3), std::string(100000, '[')}) {
    const std::string error = error_of(text);
    EXPECT_THAT(error, HasSubstr("mine.json: "));
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(Scenario, UnknownNameListsThoseThatShip) {
  const auto scenario = load_scenario("offfice");
  ASSERT_FALSE(scenario);
  EXPECT_THAT(scenario.error().message, HasSubstr("empty, office, practice"));
}

TEST(Scenario, TooManyPiecesOrRobotsAreRefused) {
  auto full = scenario_from_json(with(R"("pieces": {"cans": 400})"), "mine.json");
  ASSERT_TRUE(full);
  const auto world = World::make(full.value(), 1, 1);
  ASSERT_FALSE(world);
  EXPECT_THAT(world.error().message, HasSubstr("no room for piece"));
  const auto crowd = World::make(full.value(), 2, 1);
  ASSERT_FALSE(crowd);
  EXPECT_THAT(crowd.error().message, HasSubstr("places for 1 robots, not for 2"));
}

}  // namespace
}  // namespace galilean::sim
