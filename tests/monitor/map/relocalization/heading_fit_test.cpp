// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/heading_fit.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

constexpr std::size_t kPost = 1, kCan = 2;
constexpr double kAnyTurn_rad = 1.4, kHardlyAny_rad = 0.3;

const Pose2 kBelieved{{3, 3}, 0.4};
const std::vector<LabelledPoint> kAround{{{4.6, 3.9}, kPost, 1}, {{3.9, 2.2}, kCan, 2},
                                         {{5.1, 2.6}, kCan, 3},  {{3.4, 4.8}, kCan, 4},
                                         {{1.2, 2.0}, kCan, 5},  {{1.7, 4.1}, kPost, 6}};

/// What a robot sees that stands as it is believed to, but faces further to the left.
std::vector<LabelledPoint> seen_by_one_that_faces(double left_rad,
                                                  const std::vector<std::size_t>& which) {
  std::vector<LabelledPoint> seen;
  for (const std::size_t i : which)
    seen.push_back(
        {rotated(kAround[i].position_m - kBelieved.position_m, -kBelieved.heading_rad - left_rad),
         kAround[i].label, 0});
  return seen;
}

TEST(HeadingFit, FindsATurnByThreePoints) {
  for (const double turn_rad : {-1.2, -0.5, 0.3, 1.1}) {
    const auto found = HeadingFit::find_turn(seen_by_one_that_faces(turn_rad, {0, 1, 2}), kAround,
                                             kBelieved, 0.3, kAnyTurn_rad);
    ASSERT_TRUE(found) << turn_rad;
    EXPECT_NEAR(*found, turn_rad, HeadingFit::kDeviation_rad);
  }
}

TEST(HeadingFit, TwoPointsTellASmallTurnOnly) {
  const auto seen = seen_by_one_that_faces(0.2, {0, 2});
  const auto found = HeadingFit::find_turn(seen, kAround, kBelieved, 0.1, kHardlyAny_rad);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 0.2, HeadingFit::kDeviation_rad);
  EXPECT_FALSE(HeadingFit::find_turn(seen, kAround, kBelieved, 0.5, kAnyTurn_rad));
}

TEST(HeadingFit, FindsNothingWhereTwoTurnsFitAlike) {
  std::vector<LabelledPoint> ring;
  for (int i = 0; i < 12; ++i)
    ring.push_back({kBelieved.position_m + 1.5 * unit_vector(i * kPi / 6), kCan, 0});
  std::vector<LabelledPoint> seen;
  for (int i = 0; i < 3; ++i) seen.push_back({1.5 * unit_vector(i * kPi / 6), kCan, 0});
  EXPECT_FALSE(HeadingFit::find_turn(seen, ring, kBelieved, 0.5, kAnyTurn_rad));
}

TEST(HeadingFit, FindsNothingWhereMostIsNew) {
  auto seen = seen_by_one_that_faces(0.4, {0, 1});
  for (const Vec2& at_m : {Vec2(1, 0.9), Vec2(2.2, -1), Vec2(0.9, -0.9)})
    seen.push_back({at_m, kPost, 0});
  EXPECT_FALSE(HeadingFit::find_turn(seen, kAround, kBelieved, 0.3, kAnyTurn_rad));
  EXPECT_FALSE(HeadingFit::find_turn({}, kAround, kBelieved, 0.3, kAnyTurn_rad));
  EXPECT_FALSE(HeadingFit::find_turn(seen, {}, kBelieved, 0.3, kAnyTurn_rad));
}

}  // namespace
}  // namespace galilean::monitor
