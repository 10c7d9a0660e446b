// SPDX-License-Identifier: BSD-3-Clause
// Messages whose numbers no robot has. They come to the map by no honest way, since whatever comes
// from DDS is within its bounds. The map must not depend on that: it ends each call, and goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "monitor/map/relocalization/heading_fit.h"
#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr auto kNumbers = std::to_array<double>(
    {kInfinity, -kInfinity, kNan, 1e308, -1e308, 3e38, -3e38, 1e12, -1e12, 1e6, -1e6,
     std::numeric_limits<double>::denorm_min(), -0.0, 0, 1, -1, 0.5, 3.2});

class HostileMessagesTest : public testing::Test {
 protected:
  double number() { return kNumbers[random() % kNumbers.size()]; }
  float small_number() { return static_cast<float>(number()); }

  msg::RobotState state() {
    msg::RobotState state;
    state.robot = "io";
    state.x_m = number();
    state.y_m = number();
    state.heading_rad = number();
    return state;
  }
  msg::Sighting sighting() {
    static constexpr const char* kClasses[] = {"trash", "basket", "robot", "obstacle", ""};
    msg::Sighting sighting;
    sighting.object_class = kClasses[random() % std::size(kClasses)];
    sighting.x_m = number();
    sighting.y_m = number();
    sighting.variance_xx = number();
    sighting.variance_xy = number();
    sighting.variance_yy = number();
    sighting.range_m = small_number();
    sighting.azimuth_rad = small_number();
    sighting.left_px = sighting.top_px = sighting.right_px = sighting.bottom_px = 100;
    return sighting;
  }
  msg::Sightings frame(std::size_t sightings) {
    msg::Sightings frame;
    frame.robot = "io";
    if (random() % 2 == 0) {
      frame.x_m = number();
      frame.y_m = number();
      frame.heading_rad = number();
    }
    frame.view_angle_rad = small_number();
    while (frame.items.size() < sightings) frame.items.push_back(sighting());
    return frame;
  }
  msg::Variables variables() {
    msg::Variables variables;
    variables.robot = "io";
    for (const auto type : {msg::Variable_Constants::LOCATE, msg::Variable_Constants::BITS}) {
      msg::Variable& variable = variables.items.emplace_back();
      variable.name = "ahead";
      variable.type = type;
      variable.object_class = "obstacle";
      variable.valid = true;
      variable.certainty = small_number();
      variable.updated.sec = static_cast<std::int32_t>(random() % 100);
      variable.values = {number(), number()};
    }
    return variables;
  }
  void update() {
    now += 100ms;
    map.update(now);
  }

  std::mt19937 random{5};
  TeamMap map{2s};
  Time now{1s};
};

TEST_F(HostileMessagesTest, AnInfiniteViewAngleShowsNoMoreThanAllAround) {
  msg::Sightings all_around;
  all_around.robot = "io";
  all_around.view_angle_rad = std::numeric_limits<float>::infinity();
  map.add(all_around, now);
  update();
  EXPECT_EQ(map.objects(now, 0).robots.size(), 1U);
}

TEST_F(HostileMessagesTest, TheMapEndsEachCallAndStaysWithinItsSize) {
  for (int i = 0; i < 600; ++i) {
    map.add(state(), now);
    map.add(frame(random() % 8), now);
    map.add(variables(), now);
    if (i % 10 == 0) update();
  }
  const auto grid = map.occupancy().message();
  const double most_cells = OccupancyGridMap::kMaxSize_m / OccupancyGridMap::kCell_m + 1;
  EXPECT_LE(grid.info.width, most_cells);
  EXPECT_LE(grid.info.height, most_cells);
  EXPECT_LE(map.objects(now, 0).robots.size(), 1U);
}

TEST_F(HostileMessagesTest, ARobotWithSoundNumbersIsMappedAllTheSame) {
  for (int i = 0; i < 200; ++i) map.add(frame(3), now);
  msg::RobotState sound;
  sound.robot = "ganymede";
  sound.x_m = 1;
  for (int i = 0; i < 5; ++i) {
    map.add(sound, now);
    update();
  }
  const auto robots = map.objects(now, 0).robots;
  const auto ganymede = std::ranges::find(robots, "ganymede", &msg::MapRobot::name);
  ASSERT_NE(ganymede, robots.end());
  EXPECT_TRUE(std::isfinite(ganymede->x_m));
}

TEST_F(HostileMessagesTest, AFrameOfCountlessObjectsIsCutShort) {
  msg::Sightings crowd;
  crowd.robot = "io";
  crowd.view_angle_rad = 1;
  msg::Sighting can;
  can.object_class = "trash";
  can.x_m = can.range_m = 1;
  can.variance_xx = can.variance_yy = 9e-4;
  can.left_px = can.top_px = can.right_px = can.bottom_px = 100;
  crowd.items.assign(20'000, can);
  map.add(crowd, now);
  update();
  EXPECT_LE(map.objects(now, 0).objects.size(), 96U);
}

TEST(HostileHeadingFit, EndsWhateverItIsAskedToSearch) {
  const std::vector<LabelledPoint> points{{{1, 0}, 1, 1}, {{0, 1}, 1, 2}, {{2, 2}, 2, 3}};
  for (const double width_rad : kNumbers)
    for (const double deviation_rad : {0.1, kNan, kInfinity})
      static_cast<void>(HeadingFit::find_turn(points, points, {}, deviation_rad, width_rad));
}

}  // namespace
}  // namespace galilean::monitor
