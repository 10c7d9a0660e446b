// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/enlarge.h"
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
  EXPECT_THAT(error_of(with(R"("a\nb": 5)")), testing::Not(HasSubstr("\n")))
      << "an error is one line";
  EXPECT_THAT(error_of(with(R"("pieces": {"placed": [{"kind": "pen", "at": [1, 1]}]})")),
              HasSubstr("pieces.placed[0].kind: expected can, cup or wad, found \"pen\""));
  EXPECT_THAT(error_of(with(R"("baskets": [{"at": [9, 1]}])")),
              HasSubstr("baskets[0].at: stands outside the arena"));
  EXPECT_THAT(error_of(R"({"name": "x", "arena": {"width_m": 5, "depth_m": 4}})"),
              HasSubstr("robots.starts: expected at least one place"));
}

TEST(Scenario, WhatIsNoJsonIsOneLine) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1]"), std::string("\0\xff\xfe", 3),
        std::string(100000, '['), std::string("{\"name\": 1e999}")}) {
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

TEST(Scenario, StaysAsItIsForAsManyRobotsAsItHasPlaces) {
  const Scenario office = load_scenario("office").value();
  const Scenario same = enlarged_for(office, office.starts.size());
  EXPECT_EQ(same.starts.size(), office.starts.size());
  EXPECT_EQ(same.arena.width_m, office.arena.width_m);
  EXPECT_EQ(same.lights.size(), office.lights.size());
}

TEST(Scenario, GrowsForAHundredRobotsAndHasRoomForEach) {
  for (const auto& name : shipped_scenarios()) {
    const Scenario scenario = load_scenario(name).value();
    for (const std::size_t robots : {std::size_t{9}, std::size_t{16}, std::size_t{100}}) {
      const Scenario large = enlarged_for(scenario, robots);
      ASSERT_GE(large.starts.size(), robots) << name;
      for (std::size_t i = 0; i < large.starts.size(); ++i) {
        const Vec2& at_m = large.starts[i].position_m;
        EXPECT_TRUE(at_m.x() < large.arena.width_m && at_m.y() < large.arena.depth_m) << name << i;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_GT((at_m - large.starts[k].position_m).norm(), 0.7) << name << i << ' ' << k;
      }
      const auto world = World::make(large, robots, 1);
      EXPECT_TRUE(world) << world.error().message;
    }
  }
}

TEST(Scenario, GrowsByWholeCopiesOfItself) {
  const Scenario office = load_scenario("office").value();
  const Scenario large = enlarged_for(office, 16);
  EXPECT_EQ(large.starts.size(), 2 * office.starts.size());
  EXPECT_EQ(large.baskets_m.size(), 2 * office.baskets_m.size());
  EXPECT_EQ(World::make(large, 16, 1).value()->objects().pieces().size(), 48U);
  EXPECT_EQ(large.arena.width_m * large.arena.depth_m,
            2 * office.arena.width_m * office.arena.depth_m);
  for (std::size_t i = 0; i < office.starts.size(); ++i)
    EXPECT_EQ(large.starts[i].position_m, office.starts[i].position_m);
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
