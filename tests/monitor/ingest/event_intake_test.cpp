// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/event_intake.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/wire/cut_off_watch.h"
#include "core/wire/delivery.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

/// What comes within two seconds counts as heard in time: so many changes, with one each second.
constexpr std::size_t kInTime = 3;
/// The same with ten each second.
constexpr std::size_t kManyInTime = 21;
constexpr auto kJournal = static_cast<std::size_t>(wire::kJournalDepth);

/// A robot as its listeners hear it over DDS: states ten times a second, and its events, of which
/// the newest kJournalDepth come again to whoever is connected anew.
class TalkingRobot {
 public:
  explicit TalkingRobot(std::string writer) : writer_(std::move(writer)) {}

  void change(Time now) { sent_.push_back(now.time_since_epoch().count()); }
  [[nodiscard]] std::size_t changes() const noexcept { return sent_.size(); }
  [[nodiscard]] const std::string& writer() const noexcept { return writer_; }
  /// Returns the number of the oldest event that is kept.
  [[nodiscard]] std::size_t oldest() const noexcept {
    return changes() > kJournal ? changes() - kJournal + 1 : 1;
  }
  [[nodiscard]] std::int64_t sent_ns(std::size_t number) const { return sent_[number - 1]; }

 private:
  std::string writer_;
  std::vector<std::int64_t> sent_;
};

/// A monitor or a recorder that hears a robot, or is cut off.
struct Listener {
  wire::CutOffWatch watch;
  EventIntake intake;
  std::size_t taken = 0;

  void hear_state(Time now) { watch.note_state(now, now.time_since_epoch().count()); }
  void hear(const TalkingRobot& robot, std::size_t number, Time now) {
    const auto sent_ns = robot.sent_ns(number);
    if (intake.note(robot.writer(), number, watch.fills_gap(now, sent_ns))) ++taken;
  }
  /// What DDS does when it connects a reader.
  void connect(const TalkingRobot& robot, Time now) {
    for (auto number = robot.oldest(); number <= robot.changes(); ++number)
      hear(robot, number, now);
  }
};

class EventIntakeTest : public testing::Test {
 protected:
  /// For so long the robot tells its state, and changes it each `period`. `listeners` hear it.
  void run(TalkingRobot& robot, Duration time, Duration period, std::vector<Listener*> listeners) {
    Duration since_change{};
    for (Duration passed{}; passed < time; passed += 100ms) {
      clock.advance(100ms);
      since_change += 100ms;
      const bool changes = since_change >= period;
      if (changes) {
        robot.change(clock.now());
        since_change = {};
      }
      for (auto* listener : listeners) {
        listener->hear_state(clock.now());
        if (changes) listener->hear(robot, robot.changes(), clock.now());
      }
    }
  }

  SteppedClock clock;
  TalkingRobot io{"first"};
  Listener monitor, recorder;
};

TEST_F(EventIntakeTest, WhatIsHeardWhenItHappensFillsNothing) {
  run(io, 60s, 1s, {&monitor});
  EXPECT_EQ(monitor.taken, 60U);
  EXPECT_EQ(monitor.intake.filled(), 0U);
  EXPECT_EQ(monitor.intake.lost(), 0U);
}

TEST_F(EventIntakeTest, AGapOfFiveMinutesIsFilledAndNothingIsTakenTwice) {
  run(io, 60s, 1s, {&monitor});
  run(io, 300s, 1s, {});
  monitor.connect(io, clock.now());
  run(io, 10s, 1s, {&monitor});
  EXPECT_EQ(monitor.taken, 370U);
  EXPECT_EQ(monitor.intake.filled(), 300 - kInTime);
  EXPECT_EQ(monitor.intake.lost(), 0U);
}

TEST_F(EventIntakeTest, WhatIsBeyondTheJournalsReachIsCounted) {
  run(io, 10s, 1s, {&monitor});
  run(io, 300s, 100ms, {});
  monitor.connect(io, clock.now());
  run(io, 10s, 1s, {&monitor});
  EXPECT_EQ(monitor.intake.filled(), kJournal - kManyInTime);
  EXPECT_EQ(monitor.intake.lost(), 3000 - kJournal);
  EXPECT_EQ(monitor.taken + monitor.intake.lost(), io.changes());
}

TEST_F(EventIntakeTest, TwoListenersFillTheirOwnGaps) {
  run(io, 10s, 1s, {&monitor, &recorder});
  run(io, 60s, 1s, {&recorder});
  monitor.connect(io, clock.now());
  run(io, 10s, 1s, {&monitor, &recorder});
  run(io, 30s, 1s, {&monitor});
  recorder.connect(io, clock.now());
  run(io, 10s, 1s, {&monitor, &recorder});
  EXPECT_EQ(monitor.intake.filled(), 60 - kInTime);
  EXPECT_EQ(recorder.intake.filled(), 30 - kInTime);
  for (const auto* listener : {&monitor, &recorder}) {
    EXPECT_EQ(listener->taken, io.changes());
    EXPECT_EQ(listener->intake.lost(), 0U);
  }
}

TEST_F(EventIntakeTest, ARobotThatWasRestartedInTheGapFillsItWithItsOwnRunAlone) {
  run(io, 60s, 1s, {&monitor});
  run(io, 20s, 1s, {});
  TalkingRobot again("second");
  run(again, 40s, 1s, {});
  monitor.connect(again, clock.now());
  run(again, 10s, 1s, {&monitor});
  EXPECT_EQ(monitor.taken, 60U + again.changes());
  EXPECT_EQ(monitor.intake.filled(), 40 - kInTime);
  EXPECT_EQ(monitor.intake.lost(), 0U);
}

TEST_F(EventIntakeTest, WhoJoinsLateIsToldWhatIsKeptAndHasLostNothing) {
  run(io, 300s, 100ms, {});
  monitor.connect(io, clock.now());
  run(io, 10s, 1s, {&monitor});
  EXPECT_EQ(monitor.taken, kJournal + 10);
  EXPECT_EQ(monitor.intake.filled(), 0U);
  EXPECT_EQ(monitor.intake.lost(), 0U);
}

TEST_F(EventIntakeTest, EventsWithoutNumbersAreTakenAndNoneIsLost) {
  EventIntake intake;
  EXPECT_TRUE(intake.note("near", 0, false));
  EXPECT_TRUE(intake.note("near", 0, false));
  EXPECT_EQ(intake.lost(), 0U);
}

TEST_F(EventIntakeTest, AFloodOfWritersKeepsWhatWasCounted) {
  EventIntake intake;
  for (std::size_t i = 0; i < 3 * EventIntake::kMostWriters; ++i) {
    const auto writer = "stranger " + std::to_string(i);
    EXPECT_TRUE(intake.note(writer, 1, false));
    EXPECT_TRUE(intake.note(writer, 3, false));
  }
  EXPECT_EQ(intake.lost(), 3 * EventIntake::kMostWriters);
}

}  // namespace
}  // namespace galilean::monitor
