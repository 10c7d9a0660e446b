// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "tests/robot/perceptual/vision_test.h"

namespace galilean::robot {
namespace {

constexpr double kInch = 0.0254;
constexpr double kFoot = 12 * kInch;

class BlobDetectorTest : public VisionTest {
 protected:
  /// How far off the located can is from where it stands, `range_m` from the camera.
  double error_m(double range_m, double azimuth_deg) {
    forget_target(0.033);
    const auto finder = detector({{"threshold", 60.0}});
    const Vec2 at = Vec2(0, 0.10) + range_m * unit_vector(kPi / 2 + azimuth_deg * kPi / 180);
    show({.cylinders = {can(at)}}, *finder);
    EXPECT_TRUE(target().valid_at(tick.now)) << range_m << " m, " << azimuth_deg << " deg";
    return (target().value.position_m - at).norm();
  }
  std::unique_ptr<Schema> basket_finder(std::map<std::string, Value> more = {}) {
    forget_target(0.15);
    more.insert({{"image_variable", "dark"s},
                 {"polarity", "dark"s},
                 {"threshold", 45.0},
                 {"min_area", 60.0},
                 {"min_width", 0.18},
                 {"max_width", 0.50},
                 {"min_height", 0.18},
                 {"max_height", 0.50},
                 {"min_fill", 0.6}});
    return detector(std::move(more));
  }
};

TEST_F(BlobDetectorTest, LocatesWithinAnInchInsideThreeFeet) {
  for (const double range : {0.45, 0.5, 0.6, 0.7, 0.8, 0.9144})
    for (const double azimuth : {-30.0, -14.0, 0.0, 9.0, 30.0})
      EXPECT_LT(error_m(range, azimuth), kInch) << range << " m, " << azimuth << " deg";
}

TEST_F(BlobDetectorTest, LocatesWithinAFootAtThreeMetres) {
  for (const double range : {1.5, 2.0, 2.5, 3.0})
    for (const double azimuth : {-25.0, 0.0, 25.0})
      EXPECT_LT(error_m(range, azimuth), kFoot) << range << " m, " << azimuth << " deg";
}

TEST_F(BlobDetectorTest, LocatesInTheGlobalFrameAsOfWhenThePictureWasTaken) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}});
  const Vec2 in_robot(-0.2, 0.8);
  const Pose2 taken_at{{2, 1}, 0.7};
  const Pose2 now_at{taken_at.position_m + 0.02 * unit_vector(0.7), 0.7};
  Perspective{.cylinders = {can(in_robot)}}.draw(frame_grabber.camera, frame_grabber.picture);
  frame_grabber.picture.number = 1;
  frame_grabber.picture.captured = tick.now;
  advance(0.1);
  shaft().write({.pose = now_at, .speed_mps = 0.2}, 1, tick.now, tick.number);
  look_->run(tick);
  finder->run(tick);
  const Vec2 error = target().value.position_m - point_to_global(taken_at, in_robot);
  EXPECT_LT(error.norm(), kInch);
}

TEST_F(BlobDetectorTest, IsSurerOfWhatIsLargeAndNear) {
  error_m(0.6, 0);
  const double near = target().reliability.certainty;
  error_m(3, 0);
  const double far = target().reliability.certainty;
  EXPECT_GT(near, 0.9);
  EXPECT_GT(near, far + 0.2);
  EXPECT_GT(far, 0);
}

TEST_F(BlobDetectorTest, WritesAllSightingsNearestFirst) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}});
  show({.cylinders = {can({0.3, 2.2}), can({-0.3, 0.9}), can({0, 1.5})}}, *finder);
  const auto& sightings = target().value.sightings;
  ASSERT_EQ(sightings.size(), 3u);
  EXPECT_EQ(target().value.sightings_frame, frame_grabber.picture.number);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_LT(sightings[i - 1].range_m, sightings[i].range_m);
  EXPECT_NEAR(sightings[0].azimuth_rad, std::atan2(0.3, 0.8), 0.01);
  EXPECT_GT(sightings[0].right_px, sightings[0].left_px);
  show({}, *finder);
  EXPECT_TRUE(target().value.sightings.empty());
}

TEST_F(BlobDetectorTest, TakesWhiteGlareForNoColour) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}});
  show({.panels = {{-0.2, 0.2, 1.0, 0, 0.2, {255, 255, 250}}}}, *finder);
  EXPECT_FALSE(target().valid_at(tick.now));
}

TEST_F(BlobDetectorTest, FindsABlackBasket) {
  const auto finder = basket_finder();
  show({.cylinders = {basket({0.3, 2.0})}}, *finder);
  ASSERT_TRUE(target().valid_at(tick.now));
  EXPECT_LT((target().value.position_m - Vec2(0.3, 2.0)).norm(), 0.10);
}

TEST_F(BlobDetectorTest, RejectsADarkCeilingAndWhatRisesToIt) {
  const auto finder = basket_finder();
  show({.ceiling = kBlack, .room_depth_m = 30}, *finder);
  EXPECT_FALSE(target().valid_at(tick.now));
  show({.panels = {{-0.2, 0.2, 2.0, 0, 2.6, kBlack}}}, *finder);  // a pillar
  EXPECT_FALSE(target().valid_at(tick.now));
}

TEST_F(BlobDetectorTest, RejectsTheDarkUnderAGreenRobot) {
  const Perspective scene{
      .panels = {{-0.16, 0.16, 1.5, 0, 0.20, kBlack}, {-0.22, 0.22, 1.5, 0.20, 0.32, kGreen}}};
  const auto deceived = basket_finder();
  show(scene, *deceived);
  EXPECT_TRUE(target().valid_at(tick.now));
  const auto finder = basket_finder({{"companion_image", "green"s}});
  show(scene, *finder);
  EXPECT_FALSE(target().valid_at(tick.now));
  show({.cylinders = {basket({0.3, 2.0})}}, *finder);
  EXPECT_TRUE(target().valid_at(tick.now));
}

TEST_F(BlobDetectorTest, RejectsWhatIsNearALocatedObject) {
  locate("robot", {0, 1.5});
  const auto finder = basket_finder({{"reject_near_variable", "robot"s}, {"reject_radius", 0.4}});
  show({.cylinders = {basket({0.1, 1.6})}}, *finder);
  EXPECT_FALSE(target().valid_at(tick.now));
  show({.cylinders = {basket({0.8, 2})}}, *finder);
  EXPECT_TRUE(target().valid_at(tick.now));
}

TEST_F(BlobDetectorTest, RejectsFoldsOfATableSkirtByTheirGeometry) {
  Perspective scene{.panels = {{-1, 1, 2.0, 0, 0.7, kBlue}}};
  for (const double x : {-0.6, -0.1, 0.35})
    scene.panels.push_back({x, x + 0.09, 1.999, 0, 0.4, kDarkBlue});
  const auto finder = basket_finder();
  show(scene, *finder);
  EXPECT_FALSE(target().valid_at(tick.now));
}

TEST_F(BlobDetectorTest, LooksAtEachFrameOnce) {
  forget_target(0.033);
  const auto finder = detector({{"threshold", 60.0}});
  show({.cylinders = {can({0, 1})}}, *finder);
  const auto written = target().written_tick;
  advance();
  look_->run(tick);
  finder->run(tick);
  EXPECT_EQ(target().written_tick, written);
}

TEST_F(BlobDetectorTest, AimsAtTheNearestPointOfAWideObstacle) {
  forget_target(0);
  const auto finder = detector({{"image_variable", "blue"s}, {"aim", "lowest"s}});
  Perspective scene;
  for (int i = 0; i < 40; ++i)  // a skirt that comes nearer to the left
    scene.panels.push_back({-1.0 + 0.05 * i, -0.95 + 0.05 * i, 1.2 + 0.03 * i, 0, 0.7, kBlue});
  show(scene, *finder);
  ASSERT_TRUE(target().valid_at(tick.now));
  EXPECT_LT(target().value.position_m.x(), -0.6);
}

}  // namespace
}  // namespace galilean::robot
