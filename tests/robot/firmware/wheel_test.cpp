#include "robot/firmware/wheel.h"

#include <gtest/gtest.h>

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
  std::int16_t pwm = 0;

  Bench() { wheel.set(kGains); }
  void run(double seconds) {
    for (double t = 0; t < seconds; t += kStep_s) {
      pwm = wheel.step(motor.counts(), kZone, kStep_s);
      motor.step(pwm, kStep_s);
    }
  }
};

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

TEST(Speedometer, CountsAcrossTheEndOfTheirRange) {
  Speedometer speedometer;
  std::int32_t counts = 2147483600;
  speedometer.reset(counts);
  for (int i = 0; i < 40; ++i) {
    counts = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts) + 4);
    speedometer.sample(counts, kStep_s);
  }
  EXPECT_NEAR(speedometer.speed_counts_s(), 2000, 0.01);
}

TEST(Pid, SumsWhatItsThreeGainsSay) {
  Pid pid;
  pid.set({2, 10, 0.5f}, 1000);
  EXPECT_FLOAT_EQ(pid.step(10, 0, 0.1f), 2 * 10 + 10 * 10 * 0.1f);
  EXPECT_FLOAT_EQ(pid.step(10, 4, 0.1f), 2 * 6 + (10 + 6) - 0.5f * 4 / 0.1f);
}

TEST(Pid, DoesNotWindUpAtItsLimit) {
  Pid pid;
  pid.set({1, 10, 0}, 100);
  for (int i = 0; i < 1000; ++i) EXPECT_LE(pid.step(50, 0, 0.1f), 100);
  EXPECT_LT(pid.step(0, 50, 0.1f), 100);
  EXPECT_LT(pid.step(0, 50, 0.1f), 0);
}

}  // namespace
}  // namespace galilean::robot::firmware
