// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "robot/vision/blobs.h"
#include "robot/vision/camera_model.h"
#include "robot/vision/supercomponent.h"
#include "sim/camera/renderer.h"
#include "tests/sim/scenes.h"

namespace galilean::sim {
namespace {

constexpr int kPixels = Frame::kWidth * Frame::kHeight;
constexpr double kCanRadius_m = 0.033;
const CameraGeometry kCamera;
// The bare floor's robot stands at (3, 3) and looks along x.
const Vec2 kEye_m(3 + kCamera.forward_m, 3);

struct Picture {
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  std::vector<std::uint8_t> superred = std::vector<std::uint8_t>(kPixels);
  std::vector<std::uint8_t> intensity = std::vector<std::uint8_t>(kPixels);
};

Picture picture_of(const Scenario& scenario) {
  const auto world = world_of(scenario);
  Scene scene = scene_of(scenario);
  look_at(*world, scene);
  Renderer renderer(kCamera, scenario.camera, Random(1));
  Picture picture;
  renderer.draw(scene, 0, *picture.frame);
  robot::split_components(
      picture.frame->rgb, robot::kUnityGain,
      {.superred = picture.superred.data(), .intensity = picture.intensity.data()});
  return picture;
}

robot::BlobFinder::Blobs red_blobs(const Picture& picture) {
  static robot::BlobFinder finder;
  return finder.find(picture.superred, {60, robot::Polarity::kBright}, 6);
}

Scenario with_can(const Vec2& from_eye_m) {
  Scenario scenario = bare_floor();
  scenario.placed = {{PieceKind::kCan, kEye_m + from_eye_m}};
  return scenario;
}

TEST(Camera, LowestPixelOfACanTellsItsRange) {
  for (const double ahead_m : {0.5, 0.7, 1.0, 1.5, 2.0, 2.6}) {
    const auto blobs = red_blobs(picture_of(with_can({ahead_m, 0})));
    ASSERT_EQ(blobs.size(), 1U) << ahead_m;
    const double fy_px = 176 / std::tan(kCamera.view_angle_rad / 2) * 186 / 264;
    const double row = 93 + fy_px * kCamera.height_m / (ahead_m - kCanRadius_m);
    EXPECT_NEAR(blobs[0].bottom_px + 1, row, 1.0) << ahead_m;
  }
}

TEST(Camera, TheRobotsVisionFindsCansAsWellAsThePaperClaims) {
  const robot::CameraModel model(kCamera);
  const double inch_m = 0.0254;
  const double foot_m = 12 * inch_m;
  for (const Vec2& at :
       {Vec2(0.5, 0.2), Vec2(0.8, -0.3), Vec2(0.9, 0.1), Vec2(1.8, -0.8), Vec2(2.4, 0.9)}) {
    const auto blobs = red_blobs(picture_of(with_can(at)));
    ASSERT_EQ(blobs.size(), 1U);
    const auto found =
        model.floor_point(blobs[0].lowest_column_px + 0.5, blobs[0].bottom_px + 1, kCanRadius_m);
    ASSERT_TRUE(found);
    const Vec2 truth(-at.y(), at.x() + kCamera.forward_m);  // x right, y forward
    EXPECT_LT((found->in_robot_m - truth).norm(), at.norm() < 3 * foot_m ? inch_m : foot_m);
  }
}

TEST(Camera, FurnitureHidesWhatStandsBehindIt) {
  Scenario scenario = with_can({2, 0});
  scenario.furniture = {{FurnitureKind::kDesk, {{4.2, 3}, 0}, {0.4, 1.4}, 0.72}};
  EXPECT_EQ(red_blobs(picture_of(scenario)).size(), 0U);
  scenario.furniture[0].pose.position_m.x() = 5.6;
  EXPECT_EQ(red_blobs(picture_of(scenario)).size(), 1U);
}

TEST(Camera, NearThingsHideFarOnesOfTheirKind) {
  Scenario scenario = with_can({2, 0});
  scenario.baskets_m = {kEye_m + Vec2(1, 0)};
  EXPECT_EQ(red_blobs(picture_of(scenario)).size(), 0U);
}

TEST(Camera, ABasketIsTheDarkestThingOnTheFloor) {
  Scenario scenario = bare_floor();
  scenario.baskets_m = {kEye_m + Vec2(1.2, 0)};
  const Picture picture = picture_of(scenario);
  const auto at = [&](int column, int row) {
    return picture.intensity[static_cast<std::size_t>(row * Frame::kWidth + column)];
  };
  EXPECT_LT(at(176, 100), 50);
  EXPECT_GT(at(60, 150), 80);
}

TEST(Camera, NoiseAndGlareAreThere) {
  Scenario scenario = bare_floor();
  Light light;
  light.position_m = kEye_m + Vec2(6, 0);
  light.height_m = 1;
  scenario.lights = {light};
  const Picture picture = picture_of(scenario);
  int white = 0;
  int changes = 0;
  for (int i = 93 * Frame::kWidth; i < kPixels; ++i) {
    white += picture.intensity[static_cast<std::size_t>(i)] > 220;
    changes += picture.intensity[static_cast<std::size_t>(i)] !=
               picture.intensity[static_cast<std::size_t>(i - 1)];
  }
  EXPECT_GT(white, 50);
  EXPECT_GT(changes, kPixels / 4);
}

TEST(Camera, AnyPoseInTheOfficeCanBeDrawn) {
  const auto office = load_scenario("office");
  ASSERT_TRUE(office);
  const auto world = World::make(office.value(), 3, 3);
  ASSERT_TRUE(world);
  Scene scene = scene_of(office.value());
  look_at(*world.value(), scene);
  Renderer renderer(kCamera, office.value().camera, Random(1));
  const auto frame = std::make_unique<Frame>();
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    scene.robot_poses[0] = {{random.uniform(-1, 9), random.uniform(-1, 7)}, random.uniform(-4, 4)};
    renderer.draw(scene, 0, *frame);
  }
}

}  // namespace
}  // namespace galilean::sim
