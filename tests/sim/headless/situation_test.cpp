// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/situation.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "robot/components.h"
#include "sim/headless/headless.h"
#include "sim/headless/programs.h"

namespace galilean::sim {
namespace {

using nlohmann::json;

json situation_json(const std::string& state) {
  return {{"robots",
           {{{"name", "alpha"},
             {"x_m", 3},
             {"y_m", 2.5},
             {"heading_rad", 1},
             {"holds", "trash"},
             {"state", state},
             {"variables",
              {{{"name", "basket"},
                {"type", "locate"},
                {"object_class", "basket"},
                {"valid", true},
                {"certainty", 0.75},
                {"values", {4, 5, 0.01, 0, 0.01, 0.14}}},
               {{"name", "shaft"},
                {"type", "shaft"},
                {"valid", true},
                {"certainty", 1},
                {"values", {7, 8, 1, 0, 0}}}}}}}},
          {"objects", {{{"class", "trash"}, {"x_m", 5}, {"y_m", 1}}}},
          {"unseen_pieces", 2}};
}

TEST(Situation, BecomesAContestThatGoesOnFromThere) {
  Registry components;
  robot::add_components(components);
  const auto program = load_program("office_cleanup", components.catalog()).value();
  const std::string state = "move_to_trashcan";
  const auto read = situation_from_json(situation_json(state).dump(), "start.json");
  ASSERT_TRUE(read) << read.error().message;
  auto made =
      HeadlessContest::make(load_scenario("office").value(), components, program,
                            {.robots = 1, .seed = 1, .duration_s = 0.2, .start = &read.value()});
  ASSERT_TRUE(made) << made.error().message;
  const auto& contest = *made.value();
  EXPECT_NEAR(contest.world().robot(0).pose().position_m.x(), 3, 1e-6);
  EXPECT_EQ(contest.world().objects().pieces().size(), 4U) << "known, held and unseen";
  ASSERT_TRUE(made.value()->run());
  EXPECT_TRUE(contest.robot(0).statistics().seconds_in_state.contains(state));
  const auto& variables = contest.robot(0).executive().program()->variables;
  const auto& shaft = variables.all<Shaft>().front().value.pose.position_m;
  EXPECT_NEAR(shaft.x(), 7, 0.2) << "its odometry goes on, wherever the map has it";
}

TEST(Situation, SaysWhatIsWrongWithAFile) {
  const auto message = [](const json& document) {
    const auto read = situation_from_json(document.dump(), "start.json");
    return read ? std::string() : read.error().message;
  };
  EXPECT_EQ(message({{"robots", json::array()}}),
            "start.json: robots: expected at least one robot");
  auto wrong = situation_json("start");
  wrong["robots"][0]["x_m"] = "left";
  EXPECT_NE(message(wrong).find("robots[0].x_m: expected a number"), std::string::npos);
  EXPECT_FALSE(situation_from_json("{", "start.json"));
  EXPECT_FALSE(load_situation("/nonexistent.json"));
}

}  // namespace
}  // namespace galilean::sim
