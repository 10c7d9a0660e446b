// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/trapezoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot::firmware {
namespace {

struct Ride {
  double travelled = 0;
  float fastest = 0;
  float steepest = 0;
  double seconds = 0;
};

/// Steps until the profile rests, or for `seconds`.
Ride run(Trapezoid& profile, double seconds) {
  Ride result;
  float before = profile.speed();
  for (; result.seconds < seconds && !profile.resting(); result.seconds += kStep_s) {
    const float now = profile.step(kStep_s);
    result.travelled += (before + now) / 2.0 * kStep_s;
    result.fastest = std::max(result.fastest, std::fabs(now));
    result.steepest = std::max(result.steepest, std::fabs(now - before) / kStep_s);
    before = now;
  }
  return result;
}

TEST(Trapezoid, RampsToTheSpeedInTheTimeThatTheAccelerationGives) {
  Trapezoid profile;
  profile.aim(1600, 3200, 0);
  run(profile, 0.25f);
  EXPECT_NEAR(profile.speed(), 800, 10);
  run(profile, 0.3f);
  EXPECT_EQ(profile.speed(), 1600);
}

TEST(Trapezoid, KeepsItsSpeedWhenANewMotionReplacesTheOldOne) {
  Trapezoid profile;
  profile.aim(1600, 3200, 0);
  run(profile, 1);
  profile.aim(-1600, 3200, 0);
  EXPECT_NEAR(profile.step(kStep_s), 1600 - 3200 * kStep_s, 0.01);
}

TEST(Trapezoid, StandsAtTheTravelLimitWithinTheLimitsOfSpeedAndAcceleration) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> speeds(20, 8000), slopes(160, 16000), limits(1, 20000);
  for (int i = 0; i < 2000; ++i) {
    const float speed = speeds(random), slope = slopes(random), limit = limits(random);
    const float sign = i % 2 ? 1.0f : -1.0f;
    Trapezoid profile;
    profile.aim(sign * speed, slope, limit);
    const Ride result = run(profile, 1 + limit / speed + 2 * speed / slope);
    ASSERT_TRUE(profile.resting()) << speed << ' ' << slope << ' ' << limit;
    EXPECT_NEAR(sign * result.travelled, limit, 0.05 + 1e-4 * limit + slope * kStep_s * kStep_s);
    EXPECT_LE(result.fastest, speed);
    EXPECT_LE(result.steepest, slope * 1.02f + 1);
  }
}

TEST(Trapezoid, StandsAtTheTravelLimitHoweverLongItsStepsAre) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> speeds(20, 8000), slopes(160, 16000), limits(1, 20000);
  std::uniform_real_distribution<float> steps_s(0.001f, 0.02f);
  for (int i = 0; i < 2000; ++i) {
    const float speed = speeds(random), slope = slopes(random), limit = limits(random);
    Trapezoid profile;
    profile.aim(speed, slope, limit);
    double travelled = 0, seconds = 0;
    const double longest_s = 1 + limit / speed + 2 * speed / slope;
    for (float before = 0; !profile.resting() && seconds < longest_s; before = profile.speed()) {
      const float step_s = steps_s(random);
      travelled += (before + profile.step(step_s)) / 2.0 * step_s;
      seconds += step_s;
      ASSERT_LE(std::fabs(profile.speed() - before), slope * step_s * 1.001f);
    }
    ASSERT_TRUE(profile.resting()) << speed << ' ' << slope << ' ' << limit;
    EXPECT_NEAR(travelled, limit, 0.05 + 1e-4 * limit + slope * 0.02f * 0.02f);
  }
}

TEST(Trapezoid, OverrunsALimitThatIsTooNearByTheBrakingDistanceAlone) {
  Trapezoid profile;
  profile.aim(1600, 3200, 0);
  run(profile, 1);
  profile.aim(1600, 3200, 10);
  const Ride result = run(profile, 2);
  EXPECT_TRUE(profile.resting());
  EXPECT_NEAR(result.travelled, 1600.0f * 1600 / (2 * 3200), 4);
}

TEST(Trapezoid, ALimitAgainstThePresentDirectionIsMeasuredFromHere) {
  Trapezoid profile;
  profile.aim(1600, 3200, 0);
  run(profile, 1);
  profile.aim(-1600, 3200, 800);
  const Ride result = run(profile, 5);
  EXPECT_TRUE(profile.resting());
  EXPECT_NEAR(result.travelled, -800, 2);
}

TEST(Trapezoid, CutStandsAtOnceAndForgets) {
  Trapezoid profile;
  profile.aim(1600, 3200, 5000);
  run(profile, 0.5f);
  profile.cut();
  EXPECT_TRUE(profile.resting());
  EXPECT_EQ(profile.step(kStep_s), 0);
}

}  // namespace
}  // namespace galilean::robot::firmware
