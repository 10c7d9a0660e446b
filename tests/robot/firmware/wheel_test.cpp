// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/wheel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

#include "robot/firmware/pid.h"
#include "robot/firmware/speedometer.h"
#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot::firmware {
namespace {

constexpr float kSpeed_counts_s = 100 * kCountsPerTick;
constexpr float kSlope = 300 * kCountsPerTick;
constexpr WheelGains kGains{{8.0f / kCountsPerTick, 80.0f / kCountsPerTick, 0},
                            3.5f / kCountsPerTick};
constexpr DeadZone kZone{200, -200};

struct Bench {
  BenchMotor motor;
  Wheel wheel;
  std::uint32_t now_ms = 0;
  std::int16_t pwm = 0;

  explicit Bench(const WheelGains& gains = kGains) { wheel.set(gains); }
  void run(double seconds) {
    for (double t = 0; t < seconds; t += kStep_s) step(kStep_ms);
  }
  /// The motor goes on for so long with the PWM from before, then the loop looks at it.
  void step(std::uint32_t milliseconds) {
    for (std::uint32_t i = 0; i < milliseconds; ++i) motor.step(pwm, 0.001);
    now_ms += milliseconds;
    wheel.measure(motor.counts(), now_ms);
    pwm = wheel.step(kZone, static_cast<float>(milliseconds) / 1000);
  }
};

/// Milliseconds of a step of a loop that is often held up.
std::uint32_t uneven_step(std::mt19937& random) {
  return std::uniform_int_distribution<std::uint32_t>(1, 20)(random);
}

std::int32_t counts_at(double speed_counts_s, std::uint32_t time_ms) {
  return static_cast<std::int32_t>(std::floor(speed_counts_s * time_ms / 1000));
}

TEST(Wheel, ReachesItsSpeedBothWays) {
  for (const float speed :
       {kSpeed_counts_s, -kSpeed_counts_s, kSpeed_counts_s / 10, -kSpeed_counts_s / 10}) {
    Bench bench;
    bench.wheel.aim(speed, kSlope, 0);
    bench.run(2);
    EXPECT_NEAR(bench.motor.speed_counts_s(), speed, 0.03 * kSpeed_counts_s) << speed;
  }
}

TEST(Wheel, ReachesItsSpeedWithADeadZoneThatIsNotTheOneItWasTold) {
  for (const double zone : {100.0, 320.0}) {
    Bench bench;
    bench.motor.dead_zone_pwm = zone;
    bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
    bench.run(4);
    EXPECT_NEAR(bench.motor.speed_counts_s(), kSpeed_counts_s, 0.05 * kSpeed_counts_s) << zone;
  }
}

TEST(Wheel, StandsAtTheTravelLimitAndLetsGo) {
  for (const float limit : {16.0f, 160.0f, 1600.0f}) {
    Bench bench;
    bench.wheel.aim(kSpeed_counts_s, kSlope, limit);
    bench.run(4);
    EXPECT_NEAR(bench.motor.counts(), limit, 10) << limit;
    EXPECT_EQ(bench.pwm, 0);
    EXPECT_FALSE(bench.wheel.active());
  }
}

TEST(Wheel, PushesNoHarderAfterItWasBlocked) {
  Bench bench;
  bench.motor.blocked = true;
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(30);
  EXPECT_LE(bench.pwm, kFullPwm);
  bench.motor.blocked = false;
  bench.run(3);
  EXPECT_NEAR(bench.motor.speed_counts_s(), kSpeed_counts_s, 0.05 * kSpeed_counts_s);
}

TEST(Wheel, DrivesOnFromTheSpeedThatItHasAfterACut) {
  Bench bench;
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(1);
  bench.wheel.cut();
  bench.run(0.01);
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  for (int i = 0; i < 200; ++i) {
    bench.run(kStep_s);
    ASSERT_GE(bench.pwm, 0) << "braked against its own motion";
  }
}

TEST(Wheel, CutGivesNoPowerWhateverTheLoopWanted) {
  Bench bench;
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(1);
  bench.wheel.cut();
  bench.run(kStep_s);
  EXPECT_EQ(bench.pwm, 0);
  bench.run(1);
  EXPECT_NEAR(bench.motor.speed_counts_s(), 0, 1);
}

TEST(Wheel, BrakesBothWaysWithoutTurningBackHoweverLongItsStepsAre) {
  for (const std::uint32_t step_ms : {1u, 2u, 5u, 10u})
    for (const float speed : {kSpeed_counts_s, -kSpeed_counts_s}) {
      Bench bench;
      bench.wheel.aim(speed, kSlope, 0);
      bench.run(2);
      bench.wheel.brake();
      for (std::uint32_t ms = 0; ms < 150; ms += step_ms) {
        bench.step(step_ms);
        ASSERT_GT(bench.motor.speed_counts_s() * speed, -0.05f * speed * speed) << step_ms;
      }
      EXPECT_NEAR(bench.motor.speed_counts_s(), 0, 0.05 * kSpeed_counts_s) << step_ms;
      EXPECT_EQ(bench.pwm, 0);
      EXPECT_FALSE(bench.wheel.active());
    }
}

TEST(Wheel, IsNotPoweredToBrakeWhereItStands) {
  Bench bench;
  bench.wheel.brake();
  bench.run(kStep_s);
  EXPECT_EQ(bench.pwm, 0);
  bench.motor.blocked = true;
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(0.5);
  bench.wheel.brake();
  bench.run(kStep_s);
  EXPECT_EQ(bench.pwm, 0);
}

TEST(Wheel, HoldsItsSpeedThroughUnevenSteps) {
  std::mt19937 random(5);
  Bench bench;
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(3);
  for (int i = 0; i < 1000; ++i) {
    bench.step(uneven_step(random));
    ASSERT_NEAR(bench.motor.speed_counts_s(), kSpeed_counts_s, 0.1 * kSpeed_counts_s) << i;
  }
}

TEST(Wheel, GivesNoKickAfterAHiccup) {
  for (const std::uint32_t hiccup_ms : {3u, 20u, 60u}) {
    Bench bench;
    bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
    bench.run(3);
    const int before = bench.pwm;
    bench.step(hiccup_ms);
    EXPECT_NEAR(bench.pwm, before, 40) << hiccup_ms;
    for (int i = 0; i < 20; ++i) {
      bench.step(kStep_ms);
      EXPECT_NEAR(bench.pwm, before, 40) << hiccup_ms << " ms, then " << i;
    }
  }
}

TEST(Wheel, GivesNoKickByItsDerivativeWhenItDrivesOn) {
  WheelGains gains = kGains;
  gains.pid.derivative = 0.1f / kCountsPerTick;
  Bench bench(gains);
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(1);
  bench.wheel.cut();
  bench.run(kStep_s);
  bench.wheel.aim(kSpeed_counts_s, kSlope, 0);
  bench.run(kStep_s);
  EXPECT_GE(bench.pwm, 0) << "braked against its own motion";
}

TEST(Speedometer, IsRightAtEachStepHoweverLongItsStepsAre) {
  std::mt19937 random(3);
  for (const double speed_counts_s : {50.0, 1600.0, -1600.0, 8000.0}) {
    std::deque<std::uint32_t> window_ms{4000};
    Speedometer speedometer;
    speedometer.reset(counts_at(speed_counts_s, window_ms.back()), window_ms.back());
    for (int i = 0; i < 2000; ++i) {
      window_ms.push_back(window_ms.back() + uneven_step(random));
      if (window_ms.size() > 11) window_ms.pop_front();
      speedometer.sample(counts_at(speed_counts_s, window_ms.back()), window_ms.back());
      const double one_count = 1000.0 / (window_ms.back() - window_ms.front());
      ASSERT_NEAR(speedometer.speed_counts_s(), speed_counts_s, one_count * 1.001) << i;
    }
  }
}

TEST(Speedometer, IsRightAtTheStepAfterAHiccup) {
  constexpr double kFast_counts_s = 100000;
  for (const std::uint32_t hiccup_ms : {3u, 20u, 500u}) {
    Speedometer speedometer;
    std::uint32_t now_ms = 0;
    const auto step = [&](std::uint32_t milliseconds) {
      now_ms += milliseconds;
      speedometer.sample(counts_at(kFast_counts_s, now_ms), now_ms);
      return speedometer.speed_counts_s();
    };
    for (int i = 0; i < 20; ++i) step(kStep_ms);
    EXPECT_NEAR(step(hiccup_ms), kFast_counts_s, 0.001 * kFast_counts_s) << hiccup_ms;
    for (int i = 0; i < 20; ++i)
      EXPECT_NEAR(step(kStep_ms), kFast_counts_s, 0.001 * kFast_counts_s) << hiccup_ms;
  }
}

TEST(Speedometer, KnowsHowFastItsSpeedChangesHoweverLongItsStepsAre) {
  constexpr double kChange_counts_s2 = 400000;
  std::mt19937 random(4);
  Speedometer speedometer;
  std::uint32_t now_ms = 0;
  for (int i = 0; i < 200; ++i) {
    now_ms += uneven_step(random);
    const double seconds = now_ms / 1000.0;
    const double counts = kChange_counts_s2 / 2 * seconds * seconds;
    speedometer.sample(static_cast<std::int32_t>(counts), now_ms);
    if (i < 10) continue;  // few counts resolve no change
    ASSERT_NEAR(speedometer.change_counts_s2(), kChange_counts_s2, 0.03 * kChange_counts_s2) << i;
  }
}

TEST(Speedometer, TellsARecentSpeedThatLagsLess) {
  Speedometer speedometer;
  std::uint32_t now_ms = 0;
  std::int32_t counts = 0;
  for (int i = 0; i < 20; ++i) speedometer.sample(counts += 8, now_ms += kStep_ms);
  EXPECT_NEAR(speedometer.recent_speed_counts_s(), 4000, 0.01);
  for (int i = 0; i < 4; ++i) speedometer.sample(counts, now_ms += kStep_ms);
  EXPECT_EQ(speedometer.recent_speed_counts_s(), 0);
  EXPECT_GT(speedometer.speed_counts_s(), 2000);
  speedometer.sample(counts + 50, now_ms + 10);
  EXPECT_NEAR(speedometer.recent_speed_counts_s(), 5000, 0.01);
  speedometer.reset(7, 1000);
  EXPECT_EQ(speedometer.recent_speed_counts_s(), 0);
}

TEST(Speedometer, CountsAcrossTheEndOfTheirRange) {
  Speedometer speedometer;
  std::int32_t counts = 2147483600;
  std::uint32_t now_ms = 0xffffffe0;
  speedometer.reset(counts, now_ms);
  for (int i = 0; i < 40; ++i) {
    counts = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts) + 4);
    speedometer.sample(counts, now_ms += kStep_ms);
  }
  EXPECT_NEAR(speedometer.speed_counts_s(), 2000, 0.01);
}

TEST(Pid, SumsWhatItsThreeGainsSay) {
  Pid pid;
  pid.set({2, 10, 0.5f}, 1000);
  EXPECT_FLOAT_EQ(pid.step(10, {0, 0}, 0.1f), 2 * 10 + 10 * 10 * 0.1f);
  EXPECT_FLOAT_EQ(pid.step(10, {4, 40}, 0.1f), 2 * 6 + (10 + 6) - 0.5f * 40);
  EXPECT_FLOAT_EQ(pid.step(10, {4, 0}, 0.3f), 2 * 6 + (10 + 6 + 3 * 6)) << "a longer step";
}

TEST(Pid, DoesNotWindUpAtItsLimit) {
  Pid pid;
  pid.set({1, 10, 0}, 100);
  for (int i = 0; i < 1000; ++i) EXPECT_LE(pid.step(50, {0, 0}, 0.1f), 100);
  EXPECT_LT(pid.step(0, {50, 0}, 0.1f), 100);
  EXPECT_LT(pid.step(0, {50, 0}, 0.1f), 0);
}

}  // namespace
}  // namespace galilean::robot::firmware
