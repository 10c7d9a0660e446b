// SPDX-License-Identifier: BSD-3-Clause
// Trials with the real simulator.
#include "monitor/trial/trial.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "core/wire/messages.h"
#include "monitor/trial/situation.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

json report(double score, double seconds) {
  return {
      {"score", score},
      {"deposited", 1},
      {"collisions", 0},
      {"robots",
       {{{"seconds_in_state", {{"wander", seconds}}}}, {{"seconds_in_state", json::object()}}}}};
}

TEST(TrialFigures, AreTheMeanAndTheStandardDeviationOverTheRuns) {
  const auto side = side_of({report(10, 4), report(20, 8)});
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side.value().score.mean, 15);
  EXPECT_NEAR(side.value().score.spread, 7.071, 0.001);
  EXPECT_DOUBLE_EQ(side.value().seconds_in_state.at("wander").mean, 3) << "of two robots";
  EXPECT_FALSE(side_of({json::object()}));
}

TEST(TrialFigures, WorseIsWhatChanceDoesNotExplain) {
  const auto side = [](double mean, double spread) {
    return TrialSide{.runs = 8,
                     .score = {mean, spread},
                     .deposited = {},
                     .collisions = {},
                     .seconds_in_state = {}};
  };
  EXPECT_TRUE(clearly_worse({.now = side(30, 5), .next = side(20, 5)}));
  EXPECT_FALSE(clearly_worse({.now = side(30, 5), .next = side(27, 5)}));
  EXPECT_FALSE(clearly_worse({.now = side(30, 0), .next = side(40, 0)}));
  EXPECT_FALSE(clearly_worse({.now = {}, .next = side(-5, 0)})) << "nothing to compare with";
  EXPECT_EQ(in_words({.now = side(30, 5), .next = side(20, 5), .duration_s = 120}),
            "scores 20 ± 5; the program that runs now scores 30 ± 5 (8 runs of 120 s)");
}

TEST(Situation, IsWhatTheTeamAndItsMapKnow) {
  const SteppedClock clock;
  Team team(clock);
  msg::RobotState state;
  state.robot = "io";
  state.state = "wander";
  team.note(state);
  state.robot = "ganymede";
  team.note(state);
  msg::Score score;
  score.pieces = 10;
  score.deposited = 2;
  team.note(score);
  EXPECT_FALSE(situation_of(team, std::nullopt));

  msg::ObjectMap map;
  map.robots.push_back({.name = "io", .x_m = 1, .y_m = 2, .heading_rad = 3});
  map.objects.push_back({.object_class = "trash", .x_m = 4});
  map.objects.push_back({.object_class = "trash", .held_by = "io"});
  const auto situation = situation_of(team, map);
  ASSERT_TRUE(situation);
  ASSERT_EQ(situation.value()["robots"].size(), 1U) << "nobody knows where ganymede is";
  EXPECT_EQ(situation.value()["robots"][0]["holds"], "trash");
  EXPECT_EQ(situation.value()["robots"][0]["x_m"], 1);
  EXPECT_EQ(situation.value()["objects"].size(), 1U);
  EXPECT_EQ(situation.value()["unseen_pieces"], 6);
}

std::string text_of(const char* program) {
  std::ifstream in(std::filesystem::path(GALILEAN_BHDL_PROGRAMS) / program);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Processes that this one has started and not waited for.
std::vector<pid_t> children() {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string line;
    if (!std::getline(stat, line)) continue;  // no process, or one that has just gone
    // "pid (name) state parent …"
    std::istringstream rest(line.substr(line.rfind(')') + 1));
    char state = 0;
    pid_t parent = 0;
    if (rest >> state >> parent && parent == getpid()) found.push_back(std::stoi(line));
  }
  return found;
}

class TrialTest : public testing::Test {
 protected:
  [[nodiscard]] TrialOrder order(std::vector<bhdl::SourceFile> next) const {
    const std::vector<bhdl::SourceFile> now{{"wander.bhdl", text_of("wander.bhdl")}};
    json robot{{"name", "io"},     {"x_m", 2},        {"y_m", 2},
               {"heading_rad", 0}, {"state", "gone"}, {"variables", json::array()}};
    return {.next = std::move(next),
            .now = now,
            .situation = {{"robots", json::array({robot})},
                          {"objects", json::array()},
                          {"unseen_pieces", 3}},
            .scenario = "office",
            .seeds = 2,
            .duration_s = 2};
  }
  Result<TrialFigures> outcome(TrialOrder order, const std::filesystem::path& simulator) {
    std::optional<Result<TrialFigures>> result;
    Trial trial(io, simulator, folder / "trial", std::move(order),
                [&](const Result<TrialFigures>& figures) { result = figures; });
    io.restart();
    io.run();
    return *result;
  }

  const TemporaryFolder folder;
  boost::asio::io_context io;
};

TEST_F(TrialTest, TheSameProgramComesToTheSameTwice) {
  const auto figures = outcome(order({{"wander.bhdl", text_of("wander.bhdl")}}), GALILEAN_SIM);
  ASSERT_TRUE(figures) << figures.error().message;
  EXPECT_EQ(figures.value().next.runs, 2U);
  EXPECT_EQ(figures.value().next.score.mean, figures.value().now.score.mean);
  EXPECT_FALSE(figures.value().next.seconds_in_state.empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "trial")) << "it cleans up";
  EXPECT_THAT(children(), IsEmpty());
}

TEST_F(TrialTest, GoesOnFromWhereTheTeamIsAndScoresForTheProgramThatDoes) {
  std::vector<bhdl::SourceFile> cleanup;
  for (const auto* name : {"office_cleanup.bhdl", "office_states.bhdl", "office_robot.bhdl"})
    cleanup.push_back({name, text_of(name)});
  auto before_a_basket = order(std::move(cleanup));
  before_a_basket.duration_s = 5;
  before_a_basket.situation["objects"] = {{{"class", "basket"}, {"x_m", 0.7}, {"y_m", 4.2}}};
  before_a_basket.situation["robots"][0].update({{"x_m", 0.7},
                                                 {"y_m", 3.4},
                                                 {"heading_rad", 1.57},
                                                 {"state", "move_to_trashcan"},
                                                 {"holds", "trash"}});
  const auto figures = outcome(std::move(before_a_basket), GALILEAN_SIM);
  ASSERT_TRUE(figures) << figures.error().message;
  EXPECT_EQ(figures.value().next.score.mean, 10) << "it drops what it held into the basket";
  EXPECT_EQ(figures.value().next.deposited.mean, 1);
  EXPECT_EQ(figures.value().now.deposited.mean, 0) << "whoever wanders does not";
  EXPECT_FALSE(clearly_worse(figures.value()));
}

TEST_F(TrialTest, WhatCannotBeTriedIsSaidInWords) {
  const auto broken = outcome(order({{"broken.bhdl", "nonsense\n"}}), GALILEAN_SIM);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, HasSubstr("the program cannot be tried: "));
  EXPECT_THAT(broken.error().message, HasSubstr("broken.bhdl:1:"));
  const auto none = outcome(order({{"a.bhdl", ""}}), folder / "no-simulator");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("No such file"));
}

/// Returns a program in place of the simulator, which does what the shell's `commands` say.
std::filesystem::path simulator_that(const std::filesystem::path& folder,
                                     const std::string& commands) {
  const auto file = folder / "simulator";
  std::ofstream(file) << "#!/bin/sh\n" << commands << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

TEST_F(TrialTest, ASimulatorThatCrashesFailsTheTrialAlone) {
  const auto crashed =
      outcome(order({{"a.bhdl", ""}}), simulator_that(folder.path(), "kill -SEGV $$"));
  ASSERT_FALSE(crashed);
  EXPECT_THAT(crashed.error().message, HasSubstr("the simulator crashed (signal 11)"));
  EXPECT_THAT(children(), IsEmpty());
}

TEST_F(TrialTest, ASimulatorThatHangsFailsTheTrialInTime) {
  auto hangs = order({{"a.bhdl", ""}});
  hangs.duration_s = 0.125;
  hangs.patience_s = 0.125;
  const auto ended = outcome(std::move(hangs), simulator_that(folder.path(), "exec sleep 1000"));
  ASSERT_FALSE(ended);
  EXPECT_THAT(ended.error().message, HasSubstr("it did not end within 0.25 s"));
  EXPECT_THAT(children(), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(folder / "trial")) << "it cleans up";
}

TEST_F(TrialTest, ASimulatorThatWritesWithoutEndFillsNoDisk) {
  const auto filled =
      outcome(order({{"a.bhdl", ""}}), simulator_that(folder.path(), "exec cat /dev/zero"));
  ASSERT_FALSE(filled);
  EXPECT_THAT(filled.error().message, HasSubstr("the program"));
}

TEST_F(TrialTest, LettingGoOfItEndsItsSimulators) {
  auto long_order = order({{"wander.bhdl", text_of("wander.bhdl")}});
  long_order.duration_s = 3600;
  bool heard = false;
  std::chrono::steady_clock::time_point began;
  {
    Trial trial(io, GALILEAN_SIM, folder / "trial", std::move(long_order),
                [&](const Result<TrialFigures>&) { heard = true; });
    io.poll();
    EXPECT_THAT(children(), SizeIs(2)) << "it runs two at a time";
    began = std::chrono::steady_clock::now();
  }
  EXPECT_THAT(children(), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(folder / "trial"));
  io.restart();
  io.run();
  EXPECT_FALSE(heard);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(3));
}

}  // namespace
}  // namespace galilean::monitor
