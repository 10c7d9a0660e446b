// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

class FloorTest : public testing::Test {
 protected:
  void stand(const std::string& robot, const Pose2& pose) {
    msg::RobotState state;
    state.robot = robot;
    state.x_m = pose.position_m.x();
    state.y_m = pose.position_m.y();
    state.heading_rad = pose.heading_rad;
    map.add(state, now);
  }
  /// Io drives from the origin along x for 1 m.
  void drive() {
    for (double x_m = 0; x_m < 1; x_m += 0.05, now += 100ms) stand("io", {{x_m, 0}, 0});
  }
  /// Io reports that it touched something.
  void touch(const Vec2& at_m) {
    msg::Variables variables;
    variables.robot = "io";
    variables.items = {{.name = "ahead",
                        .type = msg::Variable_Constants::LOCATE,
                        .object_class = "obstacle",
                        .valid = true,
                        .certainty = 1,
                        .values = {at_m.x(), at_m.y()}}};
    map.add(variables, now);
  }
  /// Returns what is published of the cell: 0 (free) to 100 (occupied), -1 where it is unknown.
  [[nodiscard]] int at(const Vec2& at_m) const {
    const auto grid = map.occupancy().message();
    const Vec2 origin_m(grid.info.origin.position.x, grid.info.origin.position.y);
    const Vec2 cell = (at_m - origin_m) / OccupancyGridMap::kCell_m;
    return grid.data.at(static_cast<std::size_t>(cell.y()) * grid.info.width +
                        static_cast<std::size_t>(cell.x()));
  }

  TeamMap map{2s};
  Time now{1s};
  const Vec2 ahead_m{1.22, 0};  ///< of where io stands after its drive
};

TEST_F(FloorTest, IsFreeWhereARobotDroveAndOccupiedWhereItTouchedSomething) {
  drive();
  touch(ahead_m);
  EXPECT_LT(at({0.5, 0}), 10);
  EXPECT_GT(at(ahead_m), 80);
  EXPECT_EQ(at({-3, 3}), -1);
}

TEST_F(FloorTest, IsNotOccupiedWhereAnotherRobotWasTouched) {
  map.start_at("io", {});
  map.start_at("ganymede", {{1.4, 0}, kPi});
  stand("ganymede", {});
  drive();
  touch(ahead_m);
  EXPECT_LT(at(ahead_m), 50);
}

TEST_F(FloorTest, IsNotOccupiedWhereSomethingCameToARobotThatStood) {
  drive();
  for (int i = 0; i < 10; ++i, now += 100ms) stand("io", {{0.95, 0}, 0});
  touch(ahead_m);
  EXPECT_EQ(at(ahead_m), -1);
}

// Treads scrub in turns: after many of them nobody knows where it faces.
TEST_F(FloorTest, IsNotOccupiedWhereARobotOfUnknownPlaceTouchedSomething) {
  drive();
  for (double turned_rad = 0; turned_rad < 100; turned_rad += 0.5, now += 100ms)
    stand("io", {{0.95, 0}, turned_rad});
  touch(ahead_m);
  EXPECT_EQ(at(ahead_m), -1);
}

}  // namespace
}  // namespace galilean::monitor
