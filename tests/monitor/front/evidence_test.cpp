// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace galilean::front {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

msg::RobotState at(const std::string& robot, double x_m, std::uint64_t transitions) {
  msg::RobotState state;
  state.robot = robot;
  state.program_hash = "abc";
  state.state = "wander";
  state.x_m = x_m;
  state.transitions = transitions;
  return state;
}

TEST(Evidence, ATeamThatDroveAndChangedStatesWorked) {
  Evidence evidence({"io"});
  for (int i = 0; i <= 12; ++i) evidence.note(at("io", (i % 2) * 0.1, 1));
  EXPECT_THAT(evidence.shortcomings(), IsEmpty());
}

TEST(Evidence, EachShortcomingIsNamed) {
  Evidence evidence({"callisto", "europa", "ganymede", "io"});
  evidence.note(at("ganymede", 0, 0));
  evidence.note(at("io", 100, 3));  // where it began is not driven
  msg::RobotState idle = at("europa", 0, 1);
  idle.program_hash.clear();
  evidence.note(idle);
  EXPECT_THAT(evidence.shortcomings(),
              ElementsAre("callisto sent nothing", "europa runs no program",
                          "ganymede never left its state 'wander'",
                          "io drove less than a metre and threw nothing away"));
}

TEST(Evidence, APieceThrownAwayCountsAsWork) {
  Evidence evidence({"io"});
  evidence.note(at("io", 0, 3));
  msg::Score score;
  score.robots.push_back({"io", 1, 0});
  evidence.note(score);
  EXPECT_THAT(evidence.shortcomings(), IsEmpty());
}

TEST(Evidence, ItsSummaryTellsOfEachRobotTheScoreAndTheTimeThatIsLeft) {
  Evidence evidence({"io"});
  EXPECT_THAT(evidence.summary(), testing::HasSubstr("referee     sent no score\n"));
  evidence.note(at("io", 0, 3));
  evidence.note(at("io", 2, 4));
  msg::Score score;
  score.phase = "running";
  score.pieces = 24;
  score.deposited = 3;
  score.points = 29;
  score.collisions = 1;
  score.elapsed_s = 60;
  score.remaining_s = 540;
  score.robots.push_back({"io", 3, 1});
  evidence.note(score);
  EXPECT_THAT(evidence.summary(),
              testing::HasSubstr("in 'wander' after 4 transitions; drove 2.0 m, "
                                 "threw away 3 pieces"));
  EXPECT_THAT(evidence.summary(),
              testing::HasSubstr("contest running, 3 of 24 pieces, 1 collision, 29.0 points after "
                                 "60.0 s, 540.0 s left\n"));
}

TEST(Evidence, StrangersDoNotCount) {
  Evidence evidence({"io"});
  for (int i = 0; i < 50; ++i) evidence.note(at("ganymede", i, 4));
  EXPECT_THAT(evidence.shortcomings(), ElementsAre("io sent nothing"));
}

}  // namespace
}  // namespace galilean::front
