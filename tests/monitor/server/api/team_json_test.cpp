// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/team_json.h"

#include <gtest/gtest.h>

#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

TEST(TeamJson, TheWaitOfASilentRobotEndsAtItsLastMessage) {
  SteppedClock clock;
  clock.advance(1h);
  Team team(clock, 2s);
  msg::Breaks breaks;
  breaks.robot = "io";
  breaks.waits_at_from = "grab";
  breaks.waits_at_to = "move";
  breaks.waits_since = wire::ros_time(100'000'000'000);
  breaks.stamp = wire::ros_time(103'000'000'000);
  team.note(breaks);
  const auto io = [&] { return to_json(team)["robots"][0]; };
  clock.advance(1500ms);
  EXPECT_NEAR(io()["breaks"]["waits_s"].get<double>(), 4.5, 1e-9);
  clock.advance(60s);
  EXPECT_EQ(io()["silent"], true);
  EXPECT_NEAR(io()["breaks"]["waits_s"].get<double>(), 3.0, 1e-9);
  EXPECT_NEAR(io()["age_s"].get<double>(), 61.5, 1e-9);
}

TEST(TeamJson, SaysWhichTransitionsFillAGap) {
  SteppedClock clock;
  Team team(clock, 2s);
  msg::Transition transition;
  transition.robot = "io";
  transition.number = 1;
  team.note(transition);
  transition.number = 2;
  team.note(transition, true);
  const auto transitions = to_json(team)["robots"][0]["transitions"];
  EXPECT_EQ(transitions[0]["filled"], false);
  EXPECT_EQ(transitions[1]["filled"], true);
}

}  // namespace
}  // namespace galilean::monitor
