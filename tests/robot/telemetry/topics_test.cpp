// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "core/wire/topic_names.h"
#include "tests/robot/telemetry/telemetry_robot.h"

// Odometry, forces and diagnostics of a robot: their fields and frames.

namespace galilean::robot {
namespace {

using testing::ElementsAre;

constexpr const char* kMoves = R"(
variables:
  shaft: name: "shaft" status: "valid"
  force: name: "pull"
  force: name: "push" value: <0.5, -0.25> status: "valid"
  force: name: "sum"
end
motor_schemas:
  noise: name: "wander" persistence: 86400 shaft_variable: "shaft" result: "pull" end
  combine_forces: name: "combine" inputs: "pull" "push" gains: 0.5 1 result: "sum" end
  move_robot: name: "move" input_force: "sum" shaft_variable: "shaft" end
end
states:
  state: name: "go" motor_schemas: "wander" "combine" "move" end end
end
)";

class TopicsTest : public testing::Test {
 protected:
  TopicsTest()
      : io(std::string("t_") + testing::UnitTest::GetInstance()->current_test_info()->name()) {
    EXPECT_TRUE(io.robot.load(kMoves));
  }
  /// Ticks until a message comes: the first ones are lost while reader and writer find each other.
  template <class M>
  std::optional<M> first(Mailbox<M>& mailbox) {
    io.tick_until([&] { return !mailbox.all().empty(); });
    return mailbox.wait();
  }

  TelemetryRobot io;
};

TEST_F(TopicsTest, OdometryIsInMetresAndRadiansOfTheRobotsOwnFrame) {
  auto odometry = io.mailbox<msg::Odometry>("odom");
  ASSERT_TRUE(first(odometry));
  io.robot.port.next.left_travel_m = io.robot.port.next.right_travel_m = 0.5;
  io.robot.tick();
  // Turns on the spot by half a radian to the left: both treads by half the track times that.
  const double half_track_m = io.robot.drive.turn_radius_m();
  io.robot.port.next.left_travel_m -= half_track_m * 0.5;
  io.robot.port.next.right_travel_m += half_track_m * 0.5;
  io.robot.port.next.left_speed_mps = 0.1;
  io.robot.port.next.right_speed_mps = 0.3;
  io.robot.tick(10);
  const Pose2 pose = io.robot.executive->pose();
  const auto message = odometry.wait_for([&](const msg::Odometry& each) {
    return std::abs(each.pose.pose.position.x - pose.position_m.x()) < 1e-9 &&
           std::abs(2 * std::atan2(each.pose.pose.orientation.z, each.pose.pose.orientation.w) -
                    pose.heading_rad) < 1e-9;
  });
  ASSERT_TRUE(message);
  EXPECT_NEAR(message->pose.pose.position.x, 0.5, 1e-9);
  EXPECT_NEAR(message->pose.pose.position.y, 0, 1e-9);
  EXPECT_NEAR(message->pose.pose.orientation.z, std::sin(0.25), 1e-9);
  EXPECT_NEAR(message->pose.pose.orientation.w, std::cos(0.25), 1e-9);
  EXPECT_NEAR(message->twist.twist.linear.x, 0.2, 1e-6) << "m/s";
  EXPECT_NEAR(message->twist.twist.angular.z, 0.2 / (2 * half_track_m), 1e-6) << "rad/s";
  EXPECT_EQ(message->header.frame_id, io.name + "/odom");
  EXPECT_EQ(message->child_frame_id, io.name + "/base_link");
}

TEST_F(TopicsTest, ForcesAreThoseOfTheSchemasWithTheirGains) {
  auto forces = io.mailbox<msg::Forces>("forces");
  const auto message = first(forces);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->robot, io.name);
  std::vector<std::string> schemas;
  for (const auto& item : message->items) schemas.push_back(item.schema + ">" + item.variable);
  EXPECT_THAT(schemas, ElementsAre("wander>pull", "combine>sum"));
  const auto& pull = message->items[0];
  const auto& written = io.robot.variable<Force>("pull").value.value;
  EXPECT_FLOAT_EQ(pull.x, static_cast<float>(written.x()));
  EXPECT_FLOAT_EQ(pull.y, static_cast<float>(written.y()));
  EXPECT_FLOAT_EQ(pull.gain, 0.5F);
  EXPECT_TRUE(pull.active);
}

TEST_F(TopicsTest, DiagnosticsSayHowTheExecutiveAndTheDevicesFare) {
  auto diagnostics = Mailbox<msg::DiagnosticArray>(*io.other, wire::kDiagnosticsTopic);
  io.robot.port.answers = false;
  // The test may tick two seconds before the publisher looks again, to which the loop then stood
  // still.
  const auto is_calm = [&](const msg::DiagnosticArray& array) {
    return array.status.back().name == io.name + "/comm_port" &&
           std::ranges::count(array.status, "The control loop stands still.",
                              &msg::DiagnosticStatus::message) == 0;
  };
  io.tick_until([&] { return std::ranges::any_of(diagnostics.all(), is_calm); });
  const auto array = diagnostics.wait_for(is_calm);
  ASSERT_TRUE(array);
  ASSERT_EQ(array->status.size(), 2U);
  EXPECT_EQ(array->status[0].name, io.name + "/executive");
  EXPECT_EQ(array->status[0].level, 0);
  EXPECT_EQ(array->status[0].message, "running");
  ASSERT_EQ(array->status[0].values.size(), 3U);
  EXPECT_EQ(array->status[0].values[2].key, "overruns");
  EXPECT_EQ(array->status[0].values[2].value, "0");
  EXPECT_EQ(array->status[1].level, 2);
  EXPECT_EQ(array->status[1].message, "unplugged");
}

}  // namespace
}  // namespace galilean::robot
