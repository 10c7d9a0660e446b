// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/replay_clock.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

class ReplayClockTest : public testing::Test {
 protected:
  [[nodiscard]] double now_s() const { return to_seconds(clock.now() - Time{}); }
  void pass(double s) { real.advance(from_seconds(s)); }

  SteppedClock real;
  ReplayClock clock{real, 2};
};

TEST_F(ReplayClockTest, RunsAtItsRateWhichMayChange) {
  pass(3);
  EXPECT_NEAR(now_s(), 6, 1e-9);
  clock.set_rate(0.5);
  pass(4);
  EXPECT_NEAR(now_s(), 8, 1e-9);
  EXPECT_NEAR(to_seconds(clock.real_until(Time{} + from_seconds(9)).value()), 2, 1e-9);
}

TEST_F(ReplayClockTest, StandsStillWhileItIsPaused) {
  pass(1);
  clock.pause(true);
  pass(100);
  EXPECT_NEAR(now_s(), 2, 1e-9);
  EXPECT_FALSE(clock.real_until(Time{} + from_seconds(3)).has_value());
  EXPECT_EQ(clock.real_until(Time{} + from_seconds(2)), Duration{});
  clock.pause(false);
  pass(1);
  EXPECT_NEAR(now_s(), 4, 1e-9);
}

TEST_F(ReplayClockTest, AStepMovesItOnButNeverBack) {
  clock.pause(true);
  clock.move_to(Time{} + from_seconds(5));
  EXPECT_NEAR(now_s(), 5, 1e-9);
  clock.move_to(Time{} + from_seconds(1));
  EXPECT_NEAR(now_s(), 5, 1e-9);
}

TEST_F(ReplayClockTest, JumpsForwardAndBackAndRunsOnFromThere) {
  pass(3);
  clock.jump_to(Time{} + from_seconds(1));
  EXPECT_NEAR(now_s(), 1, 1e-9);
  pass(2);
  EXPECT_NEAR(now_s(), 5, 1e-9);
  clock.jump_to(Time{} + from_seconds(100));
  EXPECT_NEAR(now_s(), 100, 1e-9);
}

}  // namespace
}  // namespace galilean::monitor
