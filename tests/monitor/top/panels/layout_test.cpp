// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "monitor/top/screen/utf8.h"
#include "monitor/top/model/variable_text.h"

namespace galilean::monitor::top {
namespace {

using testing::HasSubstr;
using testing::Not;

ShownRobot robot(const std::string& name, char letter) {
  RobotStatus status;
  status.name = name;
  status.state = "wander_for_trash";
  status.in_state_s = 12.3;
  status.program_name = "office_cleanup";
  status.program_hash = "3f2a91c0deadbeef";
  status.age_s = 0.1;
  status.tick_time_max_us = 31;
  status.least_certain = "trash";
  status.lowest_certainty = 0.41;
  return {letter, status};
}

View team_of_three() {
  View view;
  view.robots = {robot("callisto", 'C'), robot("ganymede", 'G'), robot("io", 'I')};
  view.chosen = 2;
  view.states = {{"start"}, {"wander_for_trash", true}, {"move_to_trash"}};
  view.variables = {{"trash", "1.00, 2.00 ±0.10 m", 0.41}, {"basket", "-", 0}};
  view.map_title = "the team's map";
  view.objects = {{"trash", {1, 1}, 0.9}, {"basket", {-3, -1}, 0.9}};
  view.poses = {{2, {{0, 0}, kPi / 2}}};
  msg::Score score;
  score.scenario = "office";
  score.phase = "running";
  score.remaining_s = 451;
  score.deposited = 11;
  score.pieces = 24;
  view.score = score;
  return view;
}

TEST(TopLayout, AnswersWhoDoesWhatOnTheSmallestTerminal) {
  const std::string screen = lay_out(team_of_three(), 80, 24).text();
  for (const char* told :
       {"3 robots", "office running", "07:31 left", "11 of 24 pieces", "callisto", "ganymede", "io",
        "wander_for_trash", "12.3s", "office_clean", "3f2a91c0", "31µ", "41%", "0 collisions",
        "▶ wander_for_trash", "trash", "±0.10 m", "q quit", "the team's map"})
    EXPECT_THAT(screen, HasSubstr(told));
}

TEST(TopLayout, NeverWritesBeyondTheScreen) {
  View view = team_of_three();
  for (int i = 0; i < 60; ++i) {
    view.robots.push_back(robot("robot_with_a_very_long_name_" + std::to_string(i), 'X'));
    view.robots.back().status.problems.assign(5, std::string(300, 'p'));
    view.variables.push_back({std::string(100, 'v'), std::string(100, 'w'), 2.5});
    view.states.push_back({std::string(100, 's')});
  }
  for (int columns = 1; columns < 200; columns += 13)
    for (int rows = 1; rows < 70; rows += 5) {
      const Canvas canvas = lay_out(view, columns, rows);
      EXPECT_EQ(canvas.columns(), columns);
      for (int row = 0; row < rows; ++row) EXPECT_LE(width_of(canvas.line(row)), columns);
      (void)lay_out_help(columns, rows);
    }
}

TEST(TopLayout, ShowsTheChosenRobotHoweverManyThereAre) {
  View view = team_of_three();
  for (int i = 0; i < 30; ++i) view.robots.push_back(robot("r" + std::to_string(i), 'R'));
  for (const std::size_t chosen : {0, 15, 32}) {
    view.chosen = chosen;
    const std::string screen = lay_out(view, 80, 24).text();
    EXPECT_THAT(screen, HasSubstr(view.robots[chosen].status.name + " "));
    EXPECT_THAT(screen, HasSubstr(" more"));
  }
}

TEST(TopLayout, ProblemsOfTheChosenRobotAreSpelledOut) {
  View view = team_of_three();
  view.robots[2].status.problems = {"camera: no frame for 2 s"};
  EXPECT_THAT(lay_out(view, 80, 24).text(), HasSubstr("! io: camera: no frame for 2 s"));
}

TEST(TopLayout, MapPutsThingsWhereTheyAre) {
  const Canvas canvas = lay_out(team_of_three(), 100, 30);
  const auto find = [&](char32_t glyph) {
    for (int row = 6; row < 28; ++row)
      for (int column = 0; column < 44; ++column)
        if (canvas.at(row, column).glyph == glyph) return std::pair(row, column);
    return std::pair(-1, -1);
  };
  const auto [trash_row, trash_column] = find(U'*');
  const auto [basket_row, basket_column] = find(U'U');
  const auto [nose_row, nose_column] = find(U'↑');
  ASSERT_GT(nose_row, 0);
  EXPECT_EQ(canvas.at(nose_row + 1, nose_column).glyph, U'I');
  EXPECT_LT(trash_row, nose_row + 1);  // north of the robot
  EXPECT_GT(trash_column, nose_column);
  EXPECT_GT(basket_row, nose_row + 1);
  EXPECT_LT(basket_column, nose_column);
}

TEST(TopLayout, WhereVariablesDoNotFitTheTellingOnesComeFirst) {
  View view = team_of_three();
  view.variables.clear();
  for (int i = 0; i < 40; ++i) view.variables.push_back({"never_seen" + std::to_string(i), "-", 0});
  view.variables.push_back({"trash", "here", 0.4});
  const std::string screen = lay_out(view, 80, 24).text();
  EXPECT_THAT(screen, HasSubstr("trash "));
  EXPECT_THAT(screen, HasSubstr(" more"));
}

TEST(TopLayout, TheMapIsAsLargeAsWhatIsKnownOfTheFloor) {
  View view = team_of_three();
  msg::OccupancyGrid floor;
  floor.info.resolution = 0.5F;
  floor.info.width = floor.info.height = 200;
  floor.info.origin.position.x = floor.info.origin.position.y = -50;
  floor.data.assign(200 * 200, -1);
  floor.data[100 * 200 + 100] = 0;
  floor.data[100 * 200 + 102] = 100;
  view.floor = floor;
  const std::string screen = lay_out(view, 120, 40).text();
  EXPECT_THAT(screen, HasSubstr("▒"));
  EXPECT_THAT(screen, HasSubstr("0.11 m a column"));
  view.floor->data.resize(7);  // fewer cells than it says
  EXPECT_THAT(lay_out(view, 120, 40).text(), Not(HasSubstr("▒")));
}

TEST(TopLayout, AMapOfNumbersThatAreNoneIsDrawnWithoutThem) {
  View view = team_of_three();
  view.objects.push_back({"trash", {std::nan(""), 1}, 1});
  view.poses[0].pose.position_m.x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(lay_out(view, 80, 24).text(), HasSubstr("*"));
}

TEST(TopLayout, SaysWhatToDoWhereNoRobotIsHeard) {
  EXPECT_THAT(lay_out({}, 80, 24).text(),
              testing::AllOf(HasSubstr("No robot has been heard yet."),
                             HasSubstr("in the same DDS domain (--domain or ROS_DOMAIN_ID).")));
}

TEST(Canvas, NamesFromTheNetworkCannotMoveTheCursor) {
  Canvas canvas(40, 1);
  canvas.put(0, 0, "a\x1b[2Jb\n\xff\xc3(e\u0301)\u4e2d");
  EXPECT_EQ(canvas.line(0),
            "a?[2Jb??"
            "?(e?)?");
}

TEST(VariableText, SaysEachTypeInItsOwnTerms) {
  msg::Variable variable;
  variable.type = msg::Variable_Constants::BITS;
  variable.values = {2};
  EXPECT_EQ(variable_text(variable), "-");
  variable.valid = true;
  EXPECT_EQ(variable_text(variable), "·1······");
  variable.type = msg::Variable_Constants::SHAFT;
  EXPECT_EQ(variable_text(variable), "-");  // too few values
  variable.values = {1, 2, kPi / 2, 0, 0};
  EXPECT_EQ(variable_text(variable), "1.00, 2.00 m 90°");
  variable.type = msg::Variable_Constants::LOCATE;
  variable.values = {1, 2, 0.04, 0, 0.04, 0.1};
  EXPECT_EQ(variable_text(variable), "1.00, 2.00 ±0.20 m");
}

TEST(Letters, AreTheRobotsOwnAndNoneTwice) {
  std::vector<ShownRobot> robots;
  for (const char* name : {"callisto", "ganymede", "io", "carme", "7", "1"})
    robots.push_back({letter_for(name, robots), {}});
  std::string letters;
  for (const auto& one : robots) letters += one.letter;
  EXPECT_EQ(letters, "CGIA71");
}

}  // namespace
}  // namespace galilean::monitor::top
