// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pacing.h"

#include <gmock/gmock.h>

#include <vector>

namespace galilean::robot {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

constexpr Duration kPeriod = 50ms;

/// Returns when each tick begins, after the first deadline: `took[i]` is how long the i-th one
/// takes.
std::vector<Duration> starts(const std::vector<Duration>& took) {
  SteppedClock clock;
  clock.advance(3s);
  const Time first = clock.now();
  Pacing pacing(first, kPeriod);
  std::vector<Duration> starts;
  for (const Duration each : took) {
    if (pacing.deadline() > clock.now()) clock.advance(pacing.deadline() - clock.now());
    starts.push_back(clock.now() - first);
    clock.advance(each);
    pacing.advance(clock.now());
  }
  return starts;
}

TEST(Pacing, TicksBeginAPeriodApart) {
  EXPECT_THAT(starts({1ms, 1ms, 1ms, 1ms}), ElementsAre(0ms, 50ms, 100ms, 150ms));
}

TEST(Pacing, TheRateDoesNotDriftHoweverUnevenTicksAre) {
  std::vector<Duration> took;
  for (int i = 0; i < 100'000; ++i) took.push_back(std::chrono::microseconds(i * 7919 % 49'999));
  EXPECT_EQ(starts(took).back(), 99'999 * kPeriod);
}

TEST(Pacing, ATickThatTakesAWholePeriodDelaysNone) {
  EXPECT_THAT(starts({50ms, 1ms, 1ms}), ElementsAre(0ms, 50ms, 100ms));
}

TEST(Pacing, AfterALongTickOneTickIsMadeUpForAndTheBeatIsKept) {
  EXPECT_THAT(starts({1ms, 170ms, 1ms, 1ms, 1ms}), ElementsAre(0ms, 50ms, 220ms, 250ms, 300ms));
}

TEST(Pacing, ALateTickDoesNotMoveThoseAfterIt) {
  EXPECT_THAT(starts({60ms, 1ms, 1ms}), ElementsAre(0ms, 60ms, 100ms));
}

}  // namespace
}  // namespace galilean::robot
