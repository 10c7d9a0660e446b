// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "monitor/replay/replay_clock.h"
#include "monitor/replay/replay_keys.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;

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

TEST(ReplayKeys, AreThoseOfTheTerminalAndNoOthers) {
  EXPECT_THAT(keys_in(" .+-q"), ElementsAre(ReplayKey::kPause, ReplayKey::kStep, ReplayKey::kFaster,
                                            ReplayKey::kSlower, ReplayKey::kEnd));
  EXPECT_THAT(keys_in("\x1b[C\x1b[D\x1b[H"),
              ElementsAre(ReplayKey::kForward, ReplayKey::kBack, ReplayKey::kBegin));
  EXPECT_THAT(keys_in("xyz\x1b[A\x1b[1;5C\x1b\x1b["), ElementsAre());
  EXPECT_THAT(keys_in("\x1b[3~ "), ElementsAre(ReplayKey::kPause));
}

}  // namespace
}  // namespace galilean::monitor
