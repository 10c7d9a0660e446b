// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/wire/topic_names.h"
#include "tests/robot/telemetry/telemetry_robot.h"

// How often a robot publishes, by its own clock.

namespace galilean::robot {
namespace {

constexpr const char* kStands = R"(
variables: shaft: name: "shaft" status: "valid" end
states: state: name: "stand" end end
)";
constexpr int kTicksPerSecond = 20;
/// One message may be under way when the count begins, and the period may begin with another.
constexpr double kUnderWay = 2;

class RatesTest : public testing::Test {
 protected:
  RatesTest()
      : io(std::string("t_") + testing::UnitTest::GetInstance()->current_test_info()->name()),
        sightings(io.mailbox<msg::Sightings>("sightings")) {
    EXPECT_TRUE(io.robot.load(kStands));
  }
  /// Makes a tick with a new frame from another place, and waits until the publisher has looked at
  /// it. Returns false if it did not in 10 s.
  bool tick_with_frame() {
    drive_on();
    ++io.robot.camera.picture.number;
    io.robot.tick();
    return sightings.wait_for([this](const auto& each) { return is_new(each.x_m); }).has_value();
  }
  void drive_on() {
    io.robot.port.next.left_travel_m = io.robot.port.next.right_travel_m = ++driven_m;
  }
  [[nodiscard]] bool is_new(double x_m) const { return x_m > driven_m - 0.5; }
  /// Ticks until the publisher's messages arrive: the first ones are lost while reader and writer
  /// find each other.
  template <class M>
  void meet(Mailbox<M>& mailbox) {
    io.tick_until([&] {
      ++io.robot.camera.picture.number;
      return !mailbox.all().empty() && !sightings.all().empty();
    });
  }
  /// Returns how many messages come in `seconds` of the robot's clock.
  template <class M>
  double messages_in(int seconds, Mailbox<M>& mailbox) {
    meet(mailbox);
    EXPECT_TRUE(tick_with_frame());
    const std::size_t before = mailbox.all().size();
    for (int i = 0; i < seconds * kTicksPerSecond; ++i)
      if (!tick_with_frame()) ADD_FAILURE() << "no sightings of frame " << i;
    return static_cast<double>(mailbox.all().size() - before);
  }

  TelemetryRobot io;
  Mailbox<msg::Sightings> sightings;
  double driven_m = 0;
};

TEST_F(RatesTest, OdometryComesTenTimesASecond) {
  auto odometry = io.mailbox<msg::Odometry>("odom");
  EXPECT_NEAR(messages_in(4, odometry), 40, kUnderWay);
}

TEST_F(RatesTest, ForcesComeTenTimesASecond) {
  auto forces = io.mailbox<msg::Forces>("forces");
  EXPECT_NEAR(messages_in(4, forces), 40, kUnderWay);
}

TEST_F(RatesTest, DiagnosticsComeOnceASecond) {
  auto diagnostics = Mailbox<msg::DiagnosticArray>(*io.other, wire::kDiagnosticsTopic);
  EXPECT_NEAR(messages_in(10, diagnostics), 10, kUnderWay);
}

TEST_F(RatesTest, SightingsComeOnceAFrame) {
  auto odometry = io.mailbox<msg::Odometry>("odom");
  meet(odometry);
  ASSERT_TRUE(tick_with_frame());
  const std::size_t before = sightings.all().size();
  constexpr int kFrames = 10;
  for (int i = 0; i < kFrames; ++i) {
    ASSERT_TRUE(tick_with_frame());
    // At least one of the three ticks that follow is reported. They bring no frame.
    drive_on();
    io.robot.tick(3);
    ASSERT_TRUE(
        odometry.wait_for([this](const auto& each) { return is_new(each.pose.pose.position.x); }));
  }
  EXPECT_EQ(sightings.all().size() - before, std::size_t{kFrames});
}

}  // namespace
}  // namespace galilean::robot
