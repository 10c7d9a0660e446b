// SPDX-License-Identifier: BSD-3-Clause
// Two robots of one name obey and tell as one: somebody must hear of it.
#include "robot/telemetry/namesake_watch.h"

#include <gmock/gmock.h>

#include <limits>
#include <optional>
#include <vector>

#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

std::unique_ptr<wire::Participant> joined(const std::string& name) {
  return wire::Participant::join(name, kDomain).value();
}

/// Looks until `done` is true, for at most 10 s. Returns whether it became true.
bool looks_until(const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!done() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return done();
}

msg::RobotState state_of(const std::string& robot) {
  msg::RobotState state;
  state.robot = robot;
  return state;
}

TEST(NamesakeWatch, CountsThoseThatTellTheirStateUntilTheyAreSilent) {
  const auto own = joined("twin");
  const auto other = joined("twin");
  SteppedClock clock;
  NamesakeWatch watch(*own, "twin");
  EXPECT_EQ(watch.count(clock.now()), 0);
  wire::Writer<msg::RobotState> told(*other, wire::robot_topic("twin", "state"));
  ASSERT_TRUE(looks_until([&] { return told.readers() == 1; }));
  EXPECT_EQ(watch.count(clock.now()), 0) << "it has told nothing";
  ASSERT_TRUE(told.write(state_of("twin")));
  EXPECT_TRUE(looks_until([&] { return watch.count(clock.now()) == 1; }));
  clock.advance(NamesakeWatch::kHeardFor);
  EXPECT_EQ(watch.count(clock.now()), 1);
  clock.advance(std::chrono::milliseconds(1));
  EXPECT_EQ(watch.count(clock.now()), 0);
}

TEST(NamesakeWatch, OneThatTellsWhatIsOutOfBoundsCountsToo) {
  const auto own = joined("odd");
  const auto other = joined("odd");
  SteppedClock clock;
  NamesakeWatch watch(*own, "odd");
  wire::Writer<msg::RobotState> told(*other, wire::robot_topic("odd", "state"));
  ASSERT_TRUE(looks_until([&] { return told.readers() == 1; }));
  msg::RobotState state = state_of("odd");
  state.x_m = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(told.write(state));
  EXPECT_TRUE(looks_until([&] { return watch.count(clock.now()) == 1; }));
}

TEST(NamesakeWatch, AReplayIsNoRobot) {
  const auto own = joined("played");
  const auto replay = joined(wire::kReplayName);
  const auto robot = joined("played");
  SteppedClock clock;
  NamesakeWatch watch(*own, "played");
  wire::Writer<msg::RobotState> played(*replay, wire::robot_topic("played", "state"));
  wire::Writer<msg::RobotState> told(*robot, wire::robot_topic("played", "state"));
  ASSERT_TRUE(looks_until([&] { return played.readers() == 1 && told.readers() == 1; }));
  ASSERT_TRUE(played.write(state_of("played")));
  ASSERT_TRUE(told.write(state_of("played")));
  EXPECT_TRUE(looks_until([&] { return watch.count(clock.now()) > 0; }));
  ASSERT_TRUE(played.write(state_of("played")));
  EXPECT_EQ(watch.count(clock.now()), 1);
}

TEST(NamesakeWatch, WhoWouldBeTheSecondIsToldBeforeItBegins) {
  const auto own = joined("second");
  const auto other = joined("second");
  wire::Writer<msg::RobotState> told(*other, wire::robot_topic("second", "state"));
  ASSERT_TRUE(told.write(state_of("second")));
  const SteadyClock clock;
  NamesakeWatch watch(*own, "second");
  const auto alone = watch.expect_none(clock, [] { return false; });
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error().message, HasSubstr("a robot named second lives in DDS domain"));
  EXPECT_THAT(alone.error().message, HasSubstr("--name"));
}

TEST(NamesakeWatch, WhoIsToldToEndDoesNotWait) {
  const auto own = joined("ended");
  NamesakeWatch watch(*own, "ended");
  const SteppedClock stands_still;
  EXPECT_TRUE(watch.expect_none(stands_still, [] { return true; }));
}

/// Returns what the robot says of another one of its name; empty if nothing.
std::string said_by(TelemetryRobot& robot) {
  for (const Problem& problem : robot.telemetry->problems().all())
    if (problem.subject == "name") return problem.sentence;
  return "";
}
bool has_namesake(TelemetryRobot& robot) {
  return !said_by(robot).empty();
}

/// Lets the robot tick until it counts as one that runs already.
void outgrow_newcomers(TelemetryRobot& robot) {
  robot.robot.tick(static_cast<int>(NamesakeAlarm::kNewcomer / std::chrono::milliseconds(50)) + 1);
}

/// Ticks the robots until `done` is true, for at most 20 s of their clocks. Each tick waits until
/// it was told: the robots' clocks must not run away from DDS. Returns whether it became true.
bool tick_together(const std::vector<TelemetryRobot*>& robots, const std::function<bool()>& done) {
  auto states = robots.front()->mailbox<msg::RobotState>("state");
  for (int i = 0; i < 400 && !done(); ++i) {
    for (TelemetryRobot* each : robots) each->robot.tick();
    const std::uint64_t tick = robots.front()->robot.executive->last_tick().number;
    EXPECT_TRUE(states.wait_for([&](const auto& each) { return each.tick + 2 > tick; }));
  }
  return done();
}

/// Two robots of one name in one process.
struct Twins {
  explicit Twins(const std::string& name) : first(name) {}

  void start_second() {
    second.emplace(first.name);
    ASSERT_TRUE(second->robot.load(kWaits));
  }
  bool tick_until(const std::function<bool()>& done) {
    return tick_together({&first, &*second}, done);
  }
  bool both_say_so() { return has_namesake(first) && has_namesake(*second); }

  TelemetryRobot first;
  std::optional<TelemetryRobot> second;
};

TEST(NamesakeAlarm, BothRobotsSaySoAndTheNewcomerIsHeld) {
  Twins twins("double");
  auto& first = twins.first.robot;
  ASSERT_TRUE(first.load(kWaits));
  outgrow_newcomers(twins.first);
  twins.start_second();
  auto& second = twins.second->robot;
  EXPECT_TRUE(twins.tick_until(
      [&] { return twins.both_say_so() && second.executive->held_after_fault(); }));
  EXPECT_FALSE(first.executive->held()) << "an operator may rely on it";

  second.executive->resume();
  EXPECT_TRUE(twins.tick_until([&] { return second.executive->held_after_fault(); }))
      << "who resumes the name means the robot that is known by it";
  EXPECT_FALSE(first.executive->held());
}

TEST(NamesakeAlarm, OfTwoThatStartAtTheSameMomentNeitherMoves) {
  Twins twins("same");
  ASSERT_TRUE(twins.first.robot.load(kWaits));
  twins.start_second();
  EXPECT_TRUE(twins.tick_until([&] {
    return twins.both_say_so() && twins.first.robot.executive->held_after_fault() &&
           twins.second->robot.executive->held_after_fault();
  }));
}

TEST(NamesakeAlarm, TheOneWhoseNamesakeIsGoneMayBeResumed) {
  Twins twins("left");
  ASSERT_TRUE(twins.first.robot.load(kWaits));
  twins.start_second();
  ASSERT_TRUE(twins.tick_until([&] { return twins.first.robot.executive->held_after_fault(); }));
  twins.second.reset();
  auto& robot = twins.first;
  EXPECT_TRUE(robot.tick_until([&] { return !has_namesake(robot); }));
  EXPECT_TRUE(robot.robot.executive->held_after_fault()) << "nobody has let it go on";
  robot.robot.executive->resume();
  robot.robot.tick(20);
  EXPECT_FALSE(robot.robot.executive->held());
}

TEST(NamesakeAlarm, ThatASecondWasStartedIsSaidForAWhile) {
  TelemetryRobot robot("tried");
  ASSERT_TRUE(robot.robot.load(kWaits));
  outgrow_newcomers(robot);
  auto second = joined("tried");
  std::optional<NamesakeWatch> listens(std::in_place, *second, "tried");
  ASSERT_TRUE(tick_together({&robot}, [&] { return has_namesake(robot); }));
  EXPECT_THAT(said_by(robot), HasSubstr("Another robot named tried was started"));
  listens.reset();
  second.reset();
  const Time gone = robot.robot.now();
  const auto passed = [&](Duration time) { return robot.robot.now() - gone >= time; };
  EXPECT_TRUE(tick_together({&robot}, [&] { return passed(std::chrono::seconds(10)); }));
  EXPECT_TRUE(has_namesake(robot)) << "somebody must have the time to see it";
  EXPECT_TRUE(robot.tick_until([&] { return !has_namesake(robot); }));
  EXPECT_FALSE(robot.robot.executive->held());
}

TEST(NamesakeAlarm, OneThatStaysAndCannotBeHeardCountsAsOneThatObeys) {
  const auto of_another_release = joined("mute");
  const wire::Reader obeys(*of_another_release, wire::kCommandTopic, msg::Command::kRosType);
  TelemetryRobot robot("mute");
  ASSERT_TRUE(robot.robot.load(kWaits));
  EXPECT_TRUE(tick_together({&robot}, [&] { return robot.robot.executive->held_after_fault(); }));
  EXPECT_THAT(said_by(robot), HasSubstr("both obey every order"));
}

}  // namespace
}  // namespace galilean::robot
