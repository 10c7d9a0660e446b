// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/local_rigid_fit.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

constexpr std::size_t kBasket = 1, kTrash = 2;

/// No two correspondences are equally far apart.
const std::vector<LabelledPoint> kKnown{{{0.7, 4.2}, kBasket, 1}, {{3.6, 3.4}, kBasket, 2},
                                        {{1.3, 2.1}, kTrash, 3},  {{2.9, 1.2}, kTrash, 4},
                                        {{5.5, 2.7}, kTrash, 5},  {{2.2, 5.1}, kTrash, 6},
                                        {{4.1, 4.9}, kTrash, 7},  {{6.3, 4.4}, kTrash, 8}};
const Vec2 kRobot_m(3, 3);

/// Returns what a robot sees that is turned and shifted so much from where it is believed to be.
std::vector<LabelledPoint> seen_by_displaced(const std::vector<std::size_t>& which, double turn_rad,
                                             const Vec2& shift_m) {
  std::vector<LabelledPoint> seen;
  for (const std::size_t index : which) {
    const LabelledPoint& point = kKnown[index];
    seen.push_back({kRobot_m + shift_m + rotated(point.position_m - kRobot_m, turn_rad),
                    point.label, 100 + point.id});
  }
  return seen;
}

TEST(LocalRigidFit, IsTurnedBackToWhatItKnew) {
  const Vec2 shift_m(0.3, -0.2);
  const auto fit =
      LocalRigidFit::find(seen_by_displaced({1, 2, 3, 5, 6}, -0.7, shift_m), kKnown, kRobot_m);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->transform.heading_rad, 0.7, 1e-6);
  EXPECT_LT((fit->to_map(kRobot_m + shift_m) - kRobot_m).norm(), 1e-6);
  EXPECT_EQ(fit->agreeing.size(), 5U);
  for (const auto& pair : fit->agreeing) EXPECT_EQ(pair.other_index, 100 + pair.map_index);
}

TEST(LocalRigidFit, SomeOfWhatItSeesMayBeNew) {
  auto seen = seen_by_displaced({1, 2, 3, 5}, 0.5, Vec2::Zero());
  seen.push_back({{9, 9}, kTrash, 200});
  const auto fit = LocalRigidFit::find(seen, kKnown, kRobot_m);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->agreeing.size(), 4U);
  seen.push_back({{9, 7}, kTrash, 201});
  seen.push_back({{8, 9}, kTrash, 202});
  seen.push_back({{7, 9}, kBasket, 203});
  EXPECT_FALSE(LocalRigidFit::find(seen, kKnown, kRobot_m)) << "most of it is new: another room";
}

TEST(LocalRigidFit, IsLookedForAsFarAwayAsItMayBe) {
  const auto seen = seen_by_displaced({1, 2, 3, 5, 6}, -0.7, {2.5, -0.4});
  EXPECT_FALSE(LocalRigidFit::find(seen, kKnown, kRobot_m + Vec2(2.5, -0.4)));
  const auto fit = LocalRigidFit::find(seen, kKnown, kRobot_m + Vec2(2.5, -0.4), 3);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->transform.heading_rad, 0.7, 1e-6);
  EXPECT_EQ(fit->agreeing.size(), 5U);
}

TEST(LocalRigidFit, StaysWhereTooLittleOrNothingIsClear) {
  EXPECT_FALSE(LocalRigidFit::find({}, kKnown, kRobot_m));
  EXPECT_FALSE(
      LocalRigidFit::find(seen_by_displaced({1, 2, 3}, 0.5, Vec2::Zero()), kKnown, kRobot_m));
  EXPECT_FALSE(
      LocalRigidFit::find(seen_by_displaced({1, 2, 3, 5}, 2.5, Vec2::Zero()), kKnown, kRobot_m))
      << "no robot turns so far unnoticed";
  // A square is the same at every quarter turn.
  const std::vector<LabelledPoint> square{
      {{2, 2}, kTrash, 1}, {{4, 2}, kTrash, 2}, {{4, 4}, kTrash, 3}, {{2, 4}, kTrash, 4}};
  auto seen = square;
  for (auto& point : seen) point.position_m = kRobot_m + rotated(point.position_m - kRobot_m, 0.78);
  EXPECT_FALSE(LocalRigidFit::find(seen, square, kRobot_m)) << "either way";
}

}  // namespace
}  // namespace galilean::monitor
