// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/camera_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace galilean::robot {
namespace {

constexpr double kInch = 0.0254;
constexpr double kFoot = 12 * kInch;

class CameraModelTest : public ::testing::Test {
 protected:
  double row_of(double depth_m) { return camera_.pixel({0, depth_m + 0.10})->row; }
  CameraModel camera_{CameraGeometry{}};
};

TEST_F(CameraModelTest, TakesPictureToFloorAndBack) {
  for (const double x : {-1.5, -0.2, 0.0, 0.7})
    for (const double y : {0.6, 1.0, 3.0, 6.0}) {
      const auto pixel = camera_.pixel({x, y});
      ASSERT_TRUE(pixel);
      const auto point = camera_.floor_point(pixel->column, pixel->row, 0);
      ASSERT_TRUE(point);
      EXPECT_NEAR(point->in_robot_m.x(), x, 1e-9);
      EXPECT_NEAR(point->in_robot_m.y(), y, 1e-9);
      EXPECT_NEAR(point->range_m, std::hypot(x, y - 0.10), 1e-9);
      EXPECT_NEAR(point->azimuth_rad, std::atan2(-x, y - 0.10), 1e-9);
    }
}

TEST_F(CameraModelTest, RangeIsHeightOverTheTangent) {
  const double below = std::tan(0.2) * 166.06;  // rows below the horizon at 0.2 rad
  EXPECT_NEAR(camera_.floor_point(176, 93 + below, 0)->range_m, 0.20 / std::tan(0.2), 1e-4);
}

TEST_F(CameraModelTest, OnePixelIsAnInchAtThreeFeetAndAFootAtThreeMetres) {
  const auto one_pixel_m = [this](double depth) {
    return camera_.floor_point(176, row_of(depth) - 1, 0)->range_m - depth;
  };
  EXPECT_NEAR(one_pixel_m(3 * kFoot), 1.0 * kInch, 0.05 * kInch);
  EXPECT_NEAR(one_pixel_m(3), 11.7 * kInch, 0.05 * kInch);
  EXPECT_NEAR(camera_.floor_point(176, row_of(3), 0)->range_error_m, 9 / (0.20 * 166.06), 1e-4);
}

TEST_F(CameraModelTest, CovarianceIsLongAlongTheRayAndGrowsWithRange) {
  const Mat2 near = camera_.floor_point(176, row_of(0.5), 0)->covariance_m2;
  const Mat2 far = camera_.floor_point(176, row_of(3), 0)->covariance_m2;
  EXPECT_GT(far(1, 1), 100 * near(1, 1));
  EXPECT_GT(far(1, 1), 50 * far(0, 0));
  EXPECT_NEAR(far(0, 1), 0, 1e-12);
  const Mat2 left = camera_.floor_point(20, row_of(3), 0)->covariance_m2;
  EXPECT_LT(left(0, 1), -1e-3);  // the ray points left: x falls as y grows
}

TEST_F(CameraModelTest, SeesNoFloorAboveTheHorizonOrBehind) {
  EXPECT_FALSE(camera_.floor_point(176, 93, 0));
  EXPECT_FALSE(camera_.floor_point(176, 20, 0));
  EXPECT_FALSE(camera_.pixel({0, 0}));
  EXPECT_FALSE(camera_.sees({0, 0.3}, 4));  // under the picture's lower edge
  EXPECT_TRUE(camera_.sees({0, 1}, 4));
  EXPECT_FALSE(camera_.sees({2, 1}, 4));
}

TEST_F(CameraModelTest, MeasuresHeightAndWidth) {
  const double depth = 2;
  EXPECT_NEAR(camera_.height_m(row_of(depth), depth), 0, 1e-9);
  EXPECT_NEAR(camera_.height_m(93, depth), 0.20, 1e-9);
  EXPECT_NEAR(camera_.width_m(352, depth), 2 * depth * std::tan(73.5 / 2 * kPi / 180), 1e-9);
}

}  // namespace
}  // namespace galilean::robot
