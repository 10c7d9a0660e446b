// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/map/truth/solid_things.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

/// An arena of 4 m by 3 m with a table of 1 m by 0.6 m around (2, 2), a chair around (1, 1) and a
/// basket around (3, 1). One robot stands at (2, 1) and faces the table.
class SolidThingsTest : public testing::Test {
 protected:
  SolidThingsTest() {
    sim::Scenario scenario;
    scenario.arena = {.width_m = 4, .depth_m = 3};
    scenario.furniture = {{.pose = {{2, 2}, 0}, .size_m = {1, 0.6}}};
    scenario.chairs = {{.pose = {{1, 1}, 0}}};
    scenario.baskets_m = {{3, 1}};
    scenario.placed = {{.position_m = {2, 1.5}}};
    scenario.starts = {{{2, 1}, kPi / 2}};
    scenario.start_jitter_m = scenario.start_jitter_rad = 0;
    auto made = sim::World::make(scenario, 1, 1);
    if (!made) throw std::runtime_error(made.error().message);
    world = std::move(made).value();
  }

  std::unique_ptr<sim::World> world;
};

TEST_F(SolidThingsTest, AreAsFarAsTheNearestOfThem) {
  const SolidThings solid(*world);
  EXPECT_NEAR(solid.distance_m({0.1, 1.9}), 0.1, 1e-3) << "a wall";
  EXPECT_NEAR(solid.distance_m({2, 1.6}), 0.1, 1e-3) << "the table";
  EXPECT_NEAR(solid.distance_m({1.295, 1}), 0.1, 1e-3) << "the chair";
  EXPECT_EQ(solid.distance_m({1, 1}), 0) << "between the legs of the chair";
  EXPECT_NEAR(solid.distance_m({3, 1.24}), 0.1, 1e-3) << "the basket";
  EXPECT_EQ(solid.distance_m({2, 2}), 0) << "inside of the table";
  EXPECT_EQ(solid.distance_m({-0.5, 1}), 0) << "outside of the arena";
  EXPECT_GT(solid.distance_m({2, 1}), 0.5) << "neither trash nor a robot is solid";
}

TEST_F(SolidThingsTest, LeaveFloorBesideTheirEdges) {
  const SolidThings solid(*world);
  EXPECT_TRUE(solid.has_floor_near({2, 1.75}, 0.1));
  EXPECT_FALSE(solid.has_floor_near({2, 1.85}, 0.1));
  EXPECT_FALSE(solid.has_floor_near({-0.15, 1}, 0.1));
}

TEST_F(SolidThingsTest, HideWhatIsBehindThem) {
  const SolidThings solid(*world);
  const b2Body& self = world->robot(0).body();
  EXPECT_NEAR(solid.seen_m({2, 1}, kPi / 2, 0.8, self), 0.7, 0.02) << "trash hides no floor";
  EXPECT_NEAR(solid.seen_m({2, 1}, -kPi / 2, 0.8, self), 0.8, 0.01);
}

}  // namespace
}  // namespace galilean::monitor
