// SPDX-License-Identifier: BSD-3-Clause
// What the judge makes of messages that are missing, and of states that nobody told.
#include <gmock/gmock.h>

#include "tests/monitor/expect/judge/scene.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;

constexpr auto kStillHolds = Outcome::kHolds, kNowFails = Outcome::kFails,
               kIsOpen = Outcome::kCannotTell;

constexpr const char* kOfPassedStates =
    "io: never state is \"b\"\n"
    "io: eventually state is \"c\"\n"
    "io: always tick overruns = 0";

/// A robot that passes two transitions between two states, of which the second is "c".
void pass_two_transitions(Scene& scene) {
  scene.states(0, 2, "a");
  ++scene.robot().transitions;
  scene.states(2, 4, "c");
}

TEST(JudgeOfWhatIsMissing, AStateThatPassedUntoldCannotBeExcluded) {
  Scene scene(kOfPassedStates);
  pass_two_transitions(scene);
  const auto verdicts = scene.end(4);
  ASSERT_EQ(verdicts.size(), 3U);
  EXPECT_EQ(verdicts[0].finding.outcome, kIsOpen);
  EXPECT_EQ(verdicts[1].finding.outcome, kStillHolds);
  EXPECT_EQ(verdicts[2].finding.outcome, kStillHolds);
}

TEST(JudgeOfWhatIsMissing, WhatPassedUntoldBeforeDoesNotExcuseWhatLastedAfterwards) {
  Scene scene("io: never state is \"c\" for 1.5 s");
  pass_two_transitions(scene);
  EXPECT_EQ(scene.finding(4).outcome, kNowFails);
}

TEST(JudgeOfWhatIsMissing, ATransitionThatComesAfterALaterStateStillTellsItsOwn) {
  for (const std::string passed : {"b", "d"}) {
    Scene scene(kOfPassedStates);
    pass_two_transitions(scene);
    msg::Transition late;
    late.stamp = wire::ros_time(Scene::at(1.95));
    late.robot = "io";
    late.number = 1;
    late.from_state = "a";
    late.to_state = passed;
    scene.judge().sample(Scene::at(3.95), late);
    EXPECT_EQ(scene.end(4).at(0).finding.outcome, passed == "b" ? kNowFails : kStillHolds);
  }
}

/// Messages ten times a second, of which none comes from 5 s to 6 s.
void send_with_a_pause(Scene& scene, bool counting_on) {
  scene.state(0, "a");
  std::uint64_t number = 0;
  for (int i = 0; i < 100; ++i) {
    const bool paused = i >= 50 && i < 60;
    if (!paused || counting_on) ++number;
    if (!paused) scene.judge().message(Scene::at(0.1 * i), "/io/state", {1, number});
  }
}

TEST(JudgeOfWhatIsMissing, RatesGapsAndCountsOfATopic) {
  Scene scene("io: rate of ~/state >= 9 Hz, no gaps longer than 500 ms, no losses");
  send_with_a_pause(scene, false);
  const auto verdicts = scene.end(10);
  ASSERT_EQ(verdicts.size(), 3U);
  EXPECT_EQ(verdicts[0].finding.outcome, kNowFails);
  EXPECT_NEAR(*verdicts[0].finding.margin, -0.1, 1e-9);
  EXPECT_EQ(verdicts[1].finding.counterexamples.at(0).values, "nothing came for 1.1 s");
  EXPECT_EQ(verdicts[2].finding.outcome, kStillHolds);
}

TEST(JudgeOfWhatIsMissing, WhatMissingMessagesCouldDecideCannotBeTold) {
  Scene scene(
      "io: rate of ~/state >= 9 Hz, no gaps longer than 500 ms, no losses\n"
      "io: rate of ~/state >= 20 Hz, count of messages of ~/state >= 80\n"
      "io: count of messages of ~/state <= 95, count of messages of ~/state >= 95");
  send_with_a_pause(scene, true);
  const auto verdicts = scene.end(10);
  ASSERT_EQ(verdicts.size(), 7U);
  EXPECT_EQ(verdicts[0].finding.outcome, kIsOpen);
  EXPECT_THAT(verdicts[0].finding.reason, HasSubstr("10 messages are missing"));
  EXPECT_EQ(verdicts[1].finding.outcome, kIsOpen);
  EXPECT_EQ(verdicts[2].finding.outcome, kNowFails);
  EXPECT_EQ(verdicts[2].finding.counterexamples.at(0).values, "10 messages lost by then");
  EXPECT_EQ(verdicts[2].finding.counterexamples.at(0).at_ns, Scene::at(6));
  EXPECT_EQ(verdicts[3].finding.outcome, kNowFails);
  EXPECT_EQ(verdicts[4].finding.outcome, kStillHolds);
  EXPECT_EQ(verdicts[5].finding.outcome, kIsOpen);
  EXPECT_EQ(verdicts[6].finding.outcome, kIsOpen);
}

TEST(JudgeOfWhatIsMissing, AMessageThatIsMissingBeforeAPauseDoesNotExcuseIt) {
  Scene scene("io: no gaps in ~/state longer than 500 ms");
  scene.state(0, "a");
  std::uint64_t number = 0;
  for (const double s : {0.1, 0.2, 0.4, 2.0})
    scene.judge().message(Scene::at(s), "/io/state", {1, number += s == 0.4 ? 2 : 1});
  EXPECT_EQ(scene.finding(2).outcome, kNowFails);
}

TEST(JudgeOfWhatIsMissing, LossesAreCountedByTheNumbersOfEachWriter) {
  Scene scene("io: no losses of /tf\nio: losses of /tf = 3");
  scene.state(0, "a");
  for (int i = 0; i < 10; ++i) {
    scene.judge().message(Scene::at(i), "/tf", {1, 500U + i});
    scene.judge().message(Scene::at(i), "/tf", {2, 1U + i + (i > 5 ? 1 : 0) + (i > 7 ? 2 : 0)});
  }
  const auto verdicts = scene.end(10);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].finding.counterexamples.at(0).values, "1 message lost by then");
  EXPECT_EQ(verdicts[1].finding.outcome, kStillHolds);
}

TEST(JudgeOfWhatIsMissing, NumbersThatGoBackDoNotTellLosses) {
  Scene scene("io: no losses of /tf");
  scene.state(0, "a");
  for (const std::uint64_t number : {1, 100, 2, 101})
    scene.judge().message(Scene::at(1), "/tf", {1, number});
  const auto finding = scene.finding(2);
  EXPECT_EQ(finding.outcome, kIsOpen);
  EXPECT_THAT(finding.reason, HasSubstr("go back"));
}

TEST(JudgeOfWhatIsMissing, WhatTheRecorderCountedIsLostToo) {
  const auto outcome = [](std::uint64_t first_number, std::optional<std::uint64_t> counted) {
    Scene scene("io: no losses of /tf");
    scene.state(0, "a");
    scene.judge().message(Scene::at(1), "/tf", {1, first_number});
    scene.judge().missed("/tf", counted);
    return scene.finding(2).outcome;
  };
  EXPECT_EQ(outcome(7, 0), kStillHolds);
  EXPECT_EQ(outcome(7, 3), kNowFails);
  EXPECT_EQ(outcome(7, std::nullopt), kIsOpen);
  EXPECT_EQ(outcome(0, 0), kStillHolds);  // without a number
}

}  // namespace
}  // namespace galilean::expect
