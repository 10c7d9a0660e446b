// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/cut_off_watch.h"

#include <gtest/gtest.h>

#include <limits>

namespace galilean::wire {
namespace {

using namespace std::chrono_literals;

/// A robot whose clock is an hour behind, and a listener who hears it or does not.
class CutOffWatchTest : public testing::Test {
 protected:
  static constexpr std::int64_t kBehind_ns = 3'600'000'000'000;

  [[nodiscard]] std::int64_t robot_ns() const {
    return clock.now().time_since_epoch().count() - kBehind_ns;
  }
  void hear_for(Duration time) {
    for (Duration passed{}; passed < time; passed += 100ms) {
      watch.note_state(clock.now(), robot_ns());
      clock.advance(100ms);
    }
  }
  /// Returns the robot's time of an event in the middle of a gap of that length.
  std::int64_t cut_off_for(Duration time) {
    clock.advance(time / 2);
    const auto event_ns = robot_ns();
    clock.advance(time / 2);
    return event_ns;
  }
  [[nodiscard]] bool fills(std::int64_t event_ns) const {
    return watch.fills_gap(clock.now(), event_ns);
  }

  SteppedClock clock;
  CutOffWatch watch;
};

TEST_F(CutOffWatchTest, AnEventThatIsHeardWhenItHappensFillsNothing) {
  hear_for(1s);
  EXPECT_FALSE(fills(robot_ns()));
}

TEST_F(CutOffWatchTest, WhatHappenedBeforeTheRobotWasHeardFirstFillsNothing) {
  const auto early_ns = cut_off_for(300s);
  EXPECT_FALSE(fills(early_ns));
  hear_for(1s);
  EXPECT_FALSE(fills(early_ns));
}

TEST_F(CutOffWatchTest, WhatHappenedInAGapFillsItWhetherTheStateOrTheEventComesFirst) {
  hear_for(1s);
  const auto event_ns = cut_off_for(300s);
  EXPECT_TRUE(fills(event_ns));
  hear_for(1s);
  EXPECT_TRUE(fills(event_ns));
}

TEST_F(CutOffWatchTest, WhatHappensAfterAGapFillsNothing) {
  hear_for(1s);
  static_cast<void>(cut_off_for(300s));
  hear_for(1s);
  EXPECT_FALSE(fills(robot_ns()));
}

TEST_F(CutOffWatchTest, WhatHappenedBeforeAGapAndComesAgainFillsNothing) {
  hear_for(1s);
  const auto event_ns = robot_ns() - 500'000'000;
  static_cast<void>(cut_off_for(300s));
  EXPECT_FALSE(fills(event_ns));
  hear_for(1s);
  EXPECT_FALSE(fills(event_ns));
}

TEST_F(CutOffWatchTest, WhatARobotDoesFirstAfterItWasStartedAgainIsHeardInTime) {
  hear_for(1s);
  static_cast<void>(cut_off_for(10s));
  const auto event_ns = robot_ns();
  EXPECT_FALSE(fills(event_ns));
  clock.advance(50ms);
  hear_for(1s);
  EXPECT_FALSE(fills(event_ns));
}

TEST_F(CutOffWatchTest, StampsThatNoClockShowsAreTaken) {
  for (const auto sent_ns :
       {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    watch.note_state(clock.now(), sent_ns);
    clock.advance(10s);
    static_cast<void>(fills(-(sent_ns / 2)));
  }
}

TEST_F(CutOffWatchTest, AHiccupIsNoGap) {
  hear_for(1s);
  const auto event_ns = cut_off_for(CutOffWatch::kLeast - 200ms);
  EXPECT_FALSE(fills(event_ns));
  hear_for(1s);
  EXPECT_FALSE(fills(event_ns));
}

TEST_F(CutOffWatchTest, TheNextGapIsToldFromTheOneBefore) {
  hear_for(1s);
  static_cast<void>(cut_off_for(10s));
  hear_for(5s);
  const auto between_ns = robot_ns() - 3'000'000'000;
  const auto second_ns = cut_off_for(10s);
  hear_for(1s);
  EXPECT_TRUE(fills(second_ns));
  EXPECT_FALSE(fills(between_ns));
}

}  // namespace
}  // namespace galilean::wire
