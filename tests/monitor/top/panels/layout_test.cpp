// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "monitor/top/model/variable_text.h"
#include "monitor/top/panels/help.h"
#include "monitor/top/panels/sheet.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

ShownRobot robot(const std::string& name, const std::string& letter) {
  RobotStatus status;
  status.name = name;
  status.has_state = true;
  status.state = "wander_for_trash";
  status.in_state_s = 12.3;
  status.program_name = "office_cleanup";
  status.program_hash = "3f2a91c0deadbeef";
  status.age_s = 0.1;
  status.tick_time_max_us = 31;
  status.least_certain = "trash";
  status.lowest_certainty = 0.41;
  return {letter, 0, status};
}

View team_of_three() {
  View view;
  view.robots = {robot("callisto", "C"), robot("ganymede", "G"), robot("io", "I")};
  view.known_robots = 3;
  view.chosen = 2;
  view.machine.states = {{"start", false, true}, {"wander_for_trash", true}, {"move_to_trash"}};
  view.machine.conditions = {{"trash_known[0] = 1", "move_to_trash", false},
                             {"bumpers[1] = 1", "start", true},
                             {"bumpers[2] = 1", "start", true},
                             {"lost_bits[0] = 0", "start", std::nullopt, false}};
  view.changes = {{4.2,
                   "start",
                   "wander_for_trash",
                   "bumpers[0] became 1",
                   "office.bhdl:31",
                   {"move_to_trash"},
                   2}};
  view.variables = {{"trash", "1.00, 2.00 ±0.10 m", 0.41, {0, 0.5, 1}}, {"basket", "-", 0}};
  view.known_variables = 2;
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

std::string text_of(const View& view, int columns, int rows, const Surroundings& around = {}) {
  return lay_out(view, around, columns, rows).canvas.text();
}

TEST(TopLayout, AnswersWhoDoesWhatOnTheSmallestTerminal) {
  const std::string screen = text_of(team_of_three(), 80, 24);
  for (const char* told :
       {"3 robots", "office running", "07:31 left", "11 of 24 pieces", "callisto", "ganymede", "io",
        "wander_for_trash", "12.3s", "office_clean", "3f2a91c0", "31µ", "41%", "0 collisions",
        "▶ wander_for_trash", "trash", "±0.10 m", "q quit", "the team's map"})
    EXPECT_THAT(screen, HasSubstr(told));
}

TEST(TopLayout, NeverWritesBeyondTheScreen) {
  View view = team_of_three();
  for (int i = 0; i < 60; ++i) {
    view.robots.push_back(robot("robot_with_a_very_long_name_" + std::to_string(i), "X"));
    view.robots.back().status.problems.assign(5, std::string(300, 'p'));
    view.variables.push_back({std::string(100, 'v'), std::string(100, 'w'), 2.5});
    view.machine.states.push_back({std::string(100, 's')});
    view.machine.conditions.push_back({std::string(100, 'b'), std::string(100, 't')});
    view.changes.push_back({1e9, std::string(100, 'f'), std::string(100, 't')});
    view.alarms.push_back({{std::to_string(i), AlarmKind::kProblem, "io", std::string(300, 'w')}});
  }
  for (int columns = 1; columns < 200; columns += 13)
    for (int rows = 1; rows < 70; rows += 5) {
      const Canvas canvas = lay_out(view, {}, columns, rows).canvas;
      EXPECT_EQ(canvas.columns(), columns);
      for (int row = 0; row < rows; ++row) EXPECT_LE(width_of(canvas.line(row)), columns);
      Canvas covered = canvas;
      Sheet help = help_sheet();
      lay_over(help, covered);
    }
}

TEST(TopLayout, ShowsTheChosenRobotHoweverManyThereAre) {
  View view = team_of_three();
  for (int i = 0; i < 30; ++i) view.robots.push_back(robot("r" + std::to_string(i), "R"));
  for (const std::size_t chosen : {0, 15, 32}) {
    view.chosen = chosen;
    const std::string screen = text_of(view, 80, 24);
    EXPECT_THAT(screen, HasSubstr(view.robots[chosen].status.name + " "));
    EXPECT_THAT(screen, HasSubstr(" more"));
  }
}

PostedAlarm posted(const std::string& robot, AlarmKind kind, const std::string& words) {
  return {{words, kind, robot, words}};
}

TEST(TopLayout, AlarmsAreSpelledOutAndGroupedWhereTheyAreMany) {
  View view = team_of_three();
  view.alarms = {posted("io", AlarmKind::kProblem, "io: camera: no frame for 2 s")};
  EXPECT_THAT(text_of(view, 80, 24), HasSubstr("! io: camera: no frame for 2 s, for 0.0 s"));
  for (const char* name : {"ganymede", "callisto", "io"})
    view.alarms.push_back(posted(name, AlarmKind::kSilent, std::string(name) + " is silent"));
  const std::string screen = text_of(view, 80, 24);
  EXPECT_THAT(screen, HasSubstr("! io: camera: no frame for 2 s"));
  EXPECT_THAT(screen, HasSubstr("! 3 robots are silent: ganymede, callisto, io"));
  for (auto& alarm : view.alarms) alarm.seen = true;
  EXPECT_THAT(text_of(view, 80, 24), HasSubstr("callisto, io  (seen)"));
}

TEST(TopLayout, TellsWhichConditionFiresNow) {
  const std::string screen = text_of(team_of_three(), 100, 30);
  EXPECT_THAT(screen, ContainsRegex("├ trash_known\\[0\\] = 1  is 0 +→ move_to_trash"));
  EXPECT_THAT(screen, ContainsRegex("├ bumpers\\[1\\] = 1 +fires now → start"));
  EXPECT_THAT(screen, ContainsRegex("├ bumpers\\[2\\] = 1  is 1 +→ start"));
  EXPECT_THAT(screen, ContainsRegex("└ lost_bits\\[0\\] = 0  invalid +→ start"));
  EXPECT_THAT(screen, HasSubstr("start ← before"));
}

TEST(TopLayout, MarksBreakPointsAtStatesAndTransitions) {
  View view = team_of_three();
  view.machine.states[0].mark = BreakMark::kLock;
  view.machine.states[1].mark = BreakMark::kStop;
  view.machine.conditions[0].mark = BreakMark::kStopTeam;
  const std::string screen = text_of(view, 100, 30);
  EXPECT_THAT(screen, HasSubstr(" ■start"));
  EXPECT_THAT(screen, HasSubstr("▶●wander_for_trash"));
  EXPECT_THAT(screen, HasSubstr("├●trash_known[0] = 1"));
  EXPECT_THAT(screen, HasSubstr("├ bumpers[1] = 1"));
}

TEST(TopLayout, TellsWhyTheStateChanged) {
  const std::string screen = text_of(team_of_three(), 80, 24, {.tab = Tab::kWhy});
  for (const char* told : {"4.2 s start → wander_for_trash", "bumpers[0] became 1  office.bhdl:31",
                           "also held: move_to_trash", "2 changes before this not heard"})
    EXPECT_THAT(screen, HasSubstr(told));
}

TEST(TopLayout, TheHelpFitsTheSmallestTerminal) {
  for (const auto& line : help_sheet().lines) EXPECT_LT(width_of(line.text), 80) << line.text;
}

TEST(TopLayout, AListShowsItsChosenLine) {
  Sheet sheet{.title = "List", .lines = {}, .keys = "Esc back"};
  for (int i = 0; i < 50; ++i) sheet.lines.push_back({"line " + std::to_string(i)});
  for (const std::size_t chosen : {0, 30, 49, 20}) {
    Canvas canvas(80, 24);
    sheet.chosen = chosen;
    lay_over(sheet, canvas);
    EXPECT_THAT(canvas.text(), HasSubstr("▶ line " + std::to_string(chosen)));
  }
}

struct Size {
  int columns, rows;
};

class TopLayoutAt : public testing::TestWithParam<Size> {};

TEST_P(TopLayoutAt, ShowsAllThatIsEssential) {
  const auto [columns, rows] = GetParam();
  const Screen screen = lay_out(team_of_three(), {.remark = "cannot push"}, columns, rows);
  const std::string text = screen.canvas.text();
  for (const char* told :
       {"3 robots", "cannot push", "callisto", "ganymede", "▶ wander_for_trash",
        "fires now → start", "trash ", "±0.10 m", "STOP ALL", "q quit", "the team's map"})
    EXPECT_THAT(text, HasSubstr(told));
  EXPECT_EQ(columns >= 100 && rows >= 40, text.find("also held: move_to_trash") != text.npos);
  EXPECT_EQ(columns >= 100, text.find("▁▅█") != text.npos);
  for (const Region& region : screen.regions) {
    EXPECT_LE(region.area.row + region.area.rows, rows);
    EXPECT_LE(region.area.column + region.area.columns, columns);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TopLayoutAt,
                         testing::Values(Size{80, 24}, Size{100, 30}, Size{120, 40}, Size{200, 60}),
                         [](const auto& size) {
                           return std::to_string(size.param.columns) + "x" +
                                  std::to_string(size.param.rows);
                         });

TEST(TopLayout, AWindowThatIsTooSmallSaysSoAndStillTellsOfTheStop) {
  const std::string screen =
      text_of(team_of_three(), 40, 10, {.banner = "STOP ALL: 2 of 3 stopped"});
  for (const char* told : {"too small", "40 × 10 cells, needs 80 × 24", "STOP ALL: 2 of 3 stopped"})
    EXPECT_THAT(screen, HasSubstr(told));
  EXPECT_THAT(screen, Not(HasSubstr("callisto")));
}

TEST(TopLayout, ARobotsLineAndThePanelsAreFoundUnderTheMouse) {
  const Screen screen = lay_out(team_of_three(), {}, 80, 24);
  const auto under = [&](int row, int column) {
    for (const Region& region : screen.regions)
      if (region.area.contains(row, column)) return region;
    return Region{};
  };
  EXPECT_EQ(under(3, 70).robot, "ganymede");
  EXPECT_EQ(under(20, 5).panel, Panel::kMap);
  EXPECT_EQ(under(20, 60).panel, Panel::kVariables);
}

TEST(TopLayout, ScrollingEndsWhereThePanelEnds) {
  View view = team_of_three();
  for (int i = 0; i < 40; ++i)
    view.variables.push_back({"variable" + std::to_string(i), "here", 0.4});
  const Screen screen =
      lay_out(view, {.tab = Tab::kVariables, .scrolls = {.variables = 999}}, 80, 24);
  EXPECT_THAT(screen.canvas.text(), HasSubstr("variable39"));
  EXPECT_LT(screen.scrolls.variables, 40);
  EXPECT_THAT(screen.canvas.text(), ContainsRegex("[0-9]+ above"));
}

TEST(TopLayout, MapPutsThingsWhereTheyAre) {
  const Canvas canvas = lay_out(team_of_three(), {}, 100, 30).canvas;
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
  const std::string screen = text_of(view, 80, 24);
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
  view.floor = std::make_shared<Floor>(floor);
  const std::string screen = text_of(view, 120, 40);
  const auto has_dots = ContainsRegex("\xe2[\xa0-\xa3][\x80-\xbf]");
  EXPECT_THAT(screen, has_dots);
  EXPECT_THAT(screen, HasSubstr("0.11 m a column"));
  floor.data.resize(7);  // fewer cells than it says
  view.floor = std::make_shared<Floor>(floor);
  EXPECT_THAT(text_of(view, 120, 40), Not(has_dots));
}

TEST(TopLayout, AMapOfNumbersThatAreNoneIsDrawnWithoutThem) {
  View view = team_of_three();
  view.objects.push_back({"trash", {std::nan(""), 1}, 1});
  view.poses[0].pose.position_m.x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(text_of(view, 80, 24), HasSubstr("*"));
}

TEST(TopLayout, NumbersThatNoCellHoldsAreDrawnWithinTheirBounds) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN(), kHuge = 1e308;
  View view = team_of_three();
  for (const double number : {kNone, kHuge, -kHuge}) {
    view.robots[0].status.lowest_certainty = view.robots[0].status.tick_time_max_us = number;
    view.variables[0].certainty = number;
    view.variables[0].recent = {-kHuge, 0, kHuge};
    view.score->remaining_s = number;
    view.objects = {{"trash", {number, -number}, 1}, {"basket", {-number, number}, 1}};
    const std::string screen = text_of(view, 120, 40);
    EXPECT_THAT(screen, ContainsRegex(number > 0 ? "999:59 left" : "00:00 left"));
    EXPECT_THAT(screen, ContainsRegex(number > 0 ? "1000000µ +100%" : " 0µ +0%"));
    EXPECT_THAT(screen, HasSubstr("▁▅█"));
  }
}

TEST(TopLayout, SaysWhatToDoWhereNoRobotIsHeard) {
  EXPECT_THAT(text_of({}, 80, 24),
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

}  // namespace
}  // namespace galilean::monitor::top
