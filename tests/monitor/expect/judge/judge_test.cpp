// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/monitor/expect/judge/scene.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;

constexpr auto kHolds = Outcome::kHolds, kFails = Outcome::kFails,
               kCannotTell = Outcome::kCannotTell;

TEST(Judge, NeverForTellsWhenItWasTooLong) {
  Scene scene("io: never state is \"stuck\" for 3 s");
  scene.states(0, 2, "wander");
  scene.states(2, 6, "stuck");
  const auto finding = scene.finding(6);
  EXPECT_EQ(finding.outcome, kFails);
  ASSERT_EQ(finding.counterexamples.size(), 1U);
  EXPECT_EQ(finding.counterexamples[0].at_ns, Scene::at(5));
  EXPECT_EQ(finding.counterexamples[0].values, "state is 'stuck'");
  EXPECT_NEAR(*finding.margin, -1, 1e-6);
}

TEST(Judge, NeverForTellsHowNearItWas) {
  Scene scene("io: never state is \"stuck\" for 3 s");
  scene.states(0, 2, "stuck");
  scene.states(2, 6, "wander");
  const auto finding = scene.finding(6);
  EXPECT_EQ(finding.outcome, kHolds);
  EXPECT_NEAR(*finding.margin, 1, 1e-6);
}

TEST(Judge, SilenceIsNeverCountedAsHolding) {
  Scene scene("io: never state is \"stuck\" for 3 s");
  scene.states(0, 2, "wander");
  scene.states(9, 12, "wander");
  const auto finding = scene.finding(12);
  EXPECT_EQ(finding.outcome, kCannotTell);
  EXPECT_THAT(finding.reason, HasSubstr("5.1 s"));
}

TEST(Judge, ARobotThatWasNeverHeardCannotBeTold) {
  Scene scene("ganymede: always it is healthy\nevery robot: always it is healthy");
  const auto verdicts = scene.end(5);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].finding.outcome, kCannotTell);
  EXPECT_EQ(verdicts[0].finding.reason, "ganymede was never heard");
  EXPECT_EQ(verdicts[1].finding.outcome, kCannotTell);
  EXPECT_EQ(verdicts[1].finding.reason, "no robot was heard");
}

TEST(Judge, EventuallyKnowsTheDeadlineTheMarginAndTheEnd) {
  const char* text = "io: eventually within 5 s state is \"grab\"";
  Scene in_time(text);
  in_time.states(0, 3, "wander");
  in_time.states(3, 8, "grab");
  const auto met = in_time.finding(8);
  EXPECT_EQ(met.outcome, kHolds);
  EXPECT_NEAR(*met.margin, 2, 1e-6);
  Scene late(text);
  late.states(0, 7, "wander");
  late.states(7, 8, "grab");
  const auto missed = late.finding(8);
  EXPECT_EQ(missed.outcome, kFails);
  EXPECT_EQ(missed.counterexamples.at(0).at_ns, Scene::at(5));
  EXPECT_EQ(missed.counterexamples.at(0).values, "state is 'wander'");
  EXPECT_NEAR(*missed.margin, -2, 1e-6);
  Scene cut_off(text);
  cut_off.states(0, 3, "wander");
  const auto unknown = cut_off.finding(3);
  EXPECT_EQ(unknown.outcome, kCannotTell);
  EXPECT_THAT(unknown.reason, HasSubstr("2 s too early"));
}

TEST(Judge, AfterWaitsForEachAnswer) {
  const char* text = "io: after state becomes \"grab\", within 2 s state is \"back\"";
  Scene scene(text);
  scene.state(0, "wander");
  scene.transition(0.5, "grab");
  scene.states(0.6, 1.5, "grab");
  scene.transition(1.5, "back");
  scene.transition(1.6, "grab");
  scene.states(1.7, 5, "grab");
  const auto finding = scene.finding(5);
  EXPECT_EQ(finding.outcome, kFails);
  EXPECT_EQ(finding.failures, 1U);
  EXPECT_EQ(finding.counterexamples.at(0).at_ns, Scene::at(3.6));
  Scene never(text);
  never.states(0, 3, "wander");
  const auto vacuous = never.finding(3);
  EXPECT_EQ(vacuous.outcome, kHolds);
  EXPECT_EQ(vacuous.note, "what it begins with never happened");
}

TEST(Judge, CertaintyDecaysBetweenSamples) {
  const char* text = "io: always certainty of trash >= 0.4";
  Scene scene(text);
  scene.state(0, "wander");
  scene.trash(0, 1, 0.5);
  scene.trash(1.5, 1, 0.5);
  const auto finding = scene.finding(2);
  EXPECT_EQ(finding.outcome, kFails);
  EXPECT_EQ(finding.failures, 1U);
  EXPECT_NEAR(static_cast<double>(finding.counterexamples.at(0).at_ns - Scene::at(0)), 1.2e9, 10);
  EXPECT_NEAR(*finding.margin, -0.15, 1e-6);
  Scene kept(text);
  kept.state(0, "wander");
  for (int i = 0; i < 20; ++i) kept.trash(0.1 * i, 1, 0.5);
  EXPECT_EQ(kept.finding(2).outcome, kHolds);
}

TEST(Judge, WhatIsInvalidIsNotJudged) {
  Scene scene("io: always distance of trash > 1 m");
  scene.state(0, "wander");
  scene.trash(0, 1, 0);
  scene.trash(0.5, 0, 0, false);
  const auto finding = scene.finding(1);
  EXPECT_EQ(finding.outcome, kHolds);
  EXPECT_NEAR(*finding.margin, 4, 1e-6);
  Scene never("io: always distance of trash > 1 m");
  never.state(0, "wander");
  never.trash(0, 0, 0, false);
  EXPECT_EQ(never.finding(1).outcome, kCannotTell);
}

TEST(Judge, CountsTransitionsOfSomeRobot) {
  Scene scene("some robot: count of transitions to \"drop\" >= 2");
  scene.state(0, "wander", "io");
  scene.state(0, "wander", "europa");
  for (const double s : {0.5, 1.0}) {
    scene.transition(s, "drop", "europa");
    scene.transition(s + 0.2, "wander", "europa");
  }
  scene.transition(1.3, "drop", "io");
  const auto verdicts = scene.end(2);
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].finding.outcome, kHolds);
  EXPECT_EQ(verdicts[0].finding.note, "it holds for europa: it was so 2 times");
}

TEST(Judge, CountsAreToldWhoeverTheyAreAbout) {
  const auto note = [](const std::string& scope, const std::string& comparison) {
    Scene scene(scope + ": count of transitions" + comparison);
    scene.state(0, "a");
    for (int i = 1; i <= 5; ++i) scene.transition(0.1 * i, i % 2 == 0 ? "a" : "b");
    return scene.finding(2).note;
  };
  EXPECT_EQ(note("io", " >= 7"), "it was so 5 times");
  EXPECT_EQ(note("io", " <= 2"), "it was so 5 times");
  EXPECT_EQ(note("io", " = 5"), "it was so 5 times");
  EXPECT_EQ(note("io", " in any 1 s <= 2"), "it was so at most 5 times in 1 s");
  EXPECT_EQ(note("some robot", " >= 7"),
            "it holds for none of 1 robot; the nearest is io: it was so 5 times");
}

TEST(Judge, MessagesInAWindowAreToldAsTheyWereCounted) {
  Scene scene("io: count of messages of ~/state in any 1 s <= 2");
  scene.state(0, "a");
  for (const double s : {0.1, 0.2, 0.3, 0.4})
    scene.judge().message(Scene::at(s), "/io/state", {1, static_cast<std::uint64_t>(s * 10)});
  const auto finding = scene.finding(2);
  EXPECT_EQ(finding.outcome, kFails);
  EXPECT_EQ(finding.note, "at most 4 messages in 1 s");
  EXPECT_EQ(*finding.margin, -2);
}

TEST(Judge, NoMarginIsMinusZero) {
  for (const char* claim : {"count of transitions = 1", "count of transitions <= 1",
                            "always not tick overruns > 0", "always problems = 0"}) {
    Scene scene("io: " + std::string(claim));
    scene.state(0, "a");
    scene.transition(0.5, "b");
    const auto finding = scene.finding(1);
    EXPECT_EQ(finding.outcome, kHolds) << claim;
    ASSERT_TRUE(finding.margin) << claim;
    EXPECT_EQ(*finding.margin, 0) << claim;
    EXPECT_FALSE(std::signbit(*finding.margin)) << claim;
  }
}

TEST(Judge, ARobotThatIsMistypedIsGuessed) {
  Scene scene(
      "ganymed: always it is healthy, rate of ~/state >= 1 Hz\n"
      "team: no losses of /ganymed/state\n"
      "pluto: always it is healthy");
  scene.states(0, 1, "a", "ganymede");
  scene.states(1, 2, "a", "io");
  const auto verdicts = scene.end(2);
  ASSERT_EQ(verdicts.size(), 4U);
  EXPECT_EQ(verdicts[0].finding.reason, "ganymed was never heard; did you mean 'ganymede'?");
  EXPECT_EQ(verdicts[1].finding.reason, "nothing came on the topic; did you mean 'ganymede'?");
  EXPECT_EQ(verdicts[2].finding.reason,
            "nothing came on the topic; did you mean '/ganymede/state'?");
  EXPECT_EQ(verdicts[3].finding.reason, "pluto was never heard");
}

TEST(Judge, LostTransitionsMakeACountUncertain) {
  Scene scene("io: count of transitions to \"drop\" <= 2");
  scene.states(0, 1, "wander");
  scene.robot().transitions += 3;
  scene.states(1, 2, "wander");
  const auto finding = scene.finding(2);
  EXPECT_EQ(finding.outcome, kCannotTell);
  EXPECT_EQ(finding.reason, "the recording lacks 3 transitions of io");
}

TEST(Judge, WhatALateJoinerIsToldIsNotCounted) {
  Scene scene("io: count of transitions <= 0");
  msg::Transition old;
  old.robot = "io";
  old.number = 1;
  old.to_state = "wander";
  old.stamp = wire::ros_time(Scene::at(-30));
  scene.judge().sample(Scene::at(0), old);
  scene.robot().transitions = 1;
  scene.states(0, 1, "wander");
  EXPECT_EQ(scene.finding(1).outcome, kHolds);
}

TEST(Judge, CountsInASlidingWindow) {
  const char* text = "io: count of transitions in any 1 s <= 2";
  Scene busy(text);
  busy.state(0, "a");
  for (const double s : {0.1, 0.9, 1.05}) busy.transition(s, s == 0.9 ? "a" : "b");
  EXPECT_EQ(busy.finding(1.2).outcome, kFails);
  Scene calm(text);
  calm.state(0, "a");
  for (const double s : {0.1, 0.9, 1.2}) calm.transition(s, s == 0.9 ? "a" : "b");
  EXPECT_EQ(calm.finding(1.3).outcome, kHolds);
}

TEST(Judge, ScoreAtEndIsTheNewest) {
  Scene scene("team: score >= 4 at end");
  scene.score(0, 1);
  scene.score(5, 3);
  const auto finding = scene.finding(20);
  EXPECT_EQ(finding.outcome, kFails);
  EXPECT_EQ(finding.counterexamples.at(0).values, "score is 3");
  EXPECT_EQ(*finding.margin, -1);
}

TEST(Judge, UntilHoldsTheFirstUpToTheSecond) {
  const char* text = "io: state is \"wait\" until state is \"wander\" within 3 s";
  Scene scene(text);
  scene.states(0, 1, "wait");
  scene.states(1, 4, "wander");
  const auto finding = scene.finding(4);
  EXPECT_EQ(finding.outcome, kHolds);
  EXPECT_NEAR(*finding.margin, 2, 1e-6);
  Scene other(text);
  other.states(0, 1, "wait");
  other.states(1, 4, "lost");
  EXPECT_EQ(other.finding(4).counterexamples.at(0).at_ns, Scene::at(1));
}

TEST(Judge, DamageMakesUncertainWhatRestsOnIt) {
  Scene scene(
      "io: always tick overruns = 0\n"
      "io: eventually within 3 s state is \"grab\"\n"
      "io: eventually within 5 s state is \"late\"\n"
      "io: eventually state is \"wander\"");
  scene.states(0, 2, "wander");
  scene.judge().damage({Scene::at(2), Scene::at(4)}, "damaged");
  scene.states(4, 8, "wander");
  const auto verdicts = scene.end(8);
  ASSERT_EQ(verdicts.size(), 4U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(verdicts[i].finding.outcome, kCannotTell) << i;
  EXPECT_EQ(verdicts[3].finding.outcome, kHolds);
}

TEST(Judge, WhatIsLostBeforeTheFirstMessageAndBehindTheLastIsMissedToo) {
  for (const Span lost : {Span{Scene::at(-2), Scene::at(-1)}, Span{Scene::at(9), Scene::at(9.5)}}) {
    Scene scene(
        "io: never state is \"grab\"\n"
        "io: eventually state is \"wander\"");
    scene.states(0, 8, "wander");
    scene.judge().damage(lost, "lost");
    const auto verdicts = scene.end(8);
    ASSERT_EQ(verdicts.size(), 2U);
    EXPECT_EQ(verdicts[0].finding.outcome, kCannotTell);
    EXPECT_EQ(verdicts[0].finding.reason, "messages of that time are missing");
    EXPECT_EQ(verdicts[1].finding.outcome, kHolds);
  }
}

TEST(Judge, WhatIsLostElsewhereExcusesNoFailure) {
  Scene scene("io: never state is \"stuck\" for 2 s");
  scene.states(0, 4, "stuck");
  scene.states(4, 8, "wander");
  scene.judge().damage({Scene::at(6), Scene::at(6.5)}, "lost");
  EXPECT_EQ(scene.finding(8).outcome, kFails);
}

TEST(Judge, SaysWhichNameAProgramDoesNotHave) {
  Scene scene("io: never state is \"grab_trsh\" for 3 s, always certainty of trsh <= 1");
  msg::Program program;
  program.robot = "io";
  for (const char* name : {"wander", "grab_trash"}) program.states.emplace_back().name = name;
  scene.state(0, "wander");
  scene.judge().sample(Scene::at(0), program);
  scene.trash(0.1, 1, 0);
  const auto verdicts = scene.end(1);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].finding.reason,
            "io's program has no state 'grab_trsh'; did you mean 'grab_trash'?");
  EXPECT_EQ(verdicts[1].finding.reason, "io has no variable 'trsh'; did you mean 'trash'?");
}

TEST(Judge, TimeThatGoesBackIsNoted) {
  Scene scene("io: always tick overruns = 0");
  scene.state(1, "a");
  scene.state(0.5, "a");
  EXPECT_THAT(scene.judge().finish(Scene::at(0), Scene::at(1)).notes,
              testing::ElementsAre(HasSubstr("1 message was older than that before it")));
}

}  // namespace
}  // namespace galilean::expect
