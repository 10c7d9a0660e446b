// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/robot/perceptual/perspective.h"
#include "tests/robot/telemetry/telemetry_robot.h"

// What a robot publishes of the objects that it sees in a picture.

namespace galilean::robot {
namespace {

constexpr const char* kLooks = R"(
variables:
  shaft: name: "shaft" status: "valid" certainty: 1
  image: name: "red"
  locate: name: "can" class: "trash" radius: 3.3
end
perceptual_schemas:
  look: name: "look" red_variable: "red" end
  blob_detector: name: "finder" threshold: 60
    image_variable: "red" shaft_variable: "shaft" locate_variable: "can" end
end
states: state: name: "watch" perceptual_schemas: "look" "finder" end end end
)";

/// Centres of two cans in the robot frame (x right, y forward).
const Vec2 kNear(-0.3, 0.9);
const Vec2 kFar(0.4, 1.6);
constexpr double kDriven_m = 0.5;

/// Returns where it is in the odom frame of a robot that drove straight on.
Vec2 in_odom(const Vec2& in_robot) {
  return {kDriven_m + in_robot.y(), -in_robot.x()};
}

Cylinder can(const Vec2& centre_m) {
  return {centre_m, 0.033, 0.12, {200, 40, 40}};
}

class SightingsTest : public testing::Test {
 protected:
  SightingsTest() {
    EXPECT_TRUE(io.robot.load(kLooks));
    Perspective{.cylinders = {can(kFar), can(kNear)}}.draw(io.robot.camera.camera, picture());
    io.robot.tick();  // Odometry counts from the first reading of the encoders.
    io.robot.port.next.left_travel_m = io.robot.port.next.right_travel_m = kDriven_m;
  }
  Frame& picture() { return io.robot.camera.picture; }
  /// Takes pictures until the sightings of one arrive that was taken where the robot stopped.
  std::optional<msg::Sightings> look() {
    auto mailbox = io.mailbox<msg::Sightings>("sightings");
    const auto is_there = [](const msg::Sightings& each) { return each.x_m > kDriven_m - 1e-6; };
    io.tick_until([&] {
      ++picture().number;
      return std::ranges::any_of(mailbox.all(), is_there);
    });
    return mailbox.wait_for(is_there);
  }
  [[nodiscard]] const Sighting& written(std::size_t i) const {
    return io.robot.variable<Locate>("can").value.sightings[i];
  }

  TelemetryRobot io{"t_sightings"};
};

TEST_F(SightingsTest, SayWhereTheRobotStoodAndWhichObjectsItSaw) {
  const auto message = look();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->robot, io.name);
  EXPECT_NEAR(message->x_m, kDriven_m, 1e-9);
  EXPECT_NEAR(message->y_m, 0, 1e-9);
  EXPECT_NEAR(message->heading_rad, 0, 1e-9);
  EXPECT_FLOAT_EQ(message->view_angle_rad,
                  static_cast<float>(io.robot.camera.camera.view_angle_rad));
  ASSERT_EQ(message->items.size(), 2U);
  for (const auto& item : message->items) {
    EXPECT_EQ(item.object_class, "trash");
    EXPECT_EQ(item.variable, "can");
  }
}

TEST_F(SightingsTest, AreWhereTheObjectsStand) {
  const auto message = look();
  ASSERT_TRUE(message);
  ASSERT_EQ(message->items.size(), 2U);
  const std::array cans{kNear, kFar};
  for (std::size_t i = 0; i < cans.size(); ++i) {
    const auto& item = message->items[i];
    const Vec2 from_camera = cans[i] - Vec2(0, io.robot.camera.camera.forward_m);
    const double tolerance_m = 0.03 * from_camera.norm();
    EXPECT_NEAR(item.x_m, in_odom(cans[i]).x(), tolerance_m);
    EXPECT_NEAR(item.y_m, in_odom(cans[i]).y(), tolerance_m);
    EXPECT_NEAR(item.range_m, from_camera.norm(), 0.05);
    EXPECT_NEAR(item.azimuth_rad, std::atan2(-from_camera.x(), from_camera.y()), 0.02);
  }
}

TEST_F(SightingsTest, HaveTheUncertaintyAndThePixelsOfTheLocateVariable) {
  const auto message = look();
  ASSERT_TRUE(message);
  ASSERT_EQ(message->items.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& item = message->items[i];
    const Sighting& sighting = written(i);
    EXPECT_DOUBLE_EQ(item.variance_xx, sighting.covariance_m2(0, 0));
    EXPECT_DOUBLE_EQ(item.variance_xy, sighting.covariance_m2(0, 1));
    EXPECT_DOUBLE_EQ(item.variance_yy, sighting.covariance_m2(1, 1));
    EXPECT_EQ(item.left_px, sighting.left_px);
    EXPECT_EQ(item.top_px, sighting.top_px);
    EXPECT_EQ(item.right_px, sighting.right_px);
    EXPECT_EQ(item.bottom_px, sighting.bottom_px);
    EXPECT_EQ(item.area_px, sighting.area_px);
  }
  EXPECT_LT(message->items[0].left_px, message->items[1].left_px) << "the near can is on the left";
}

}  // namespace
}  // namespace galilean::robot
