#include "monitor/map/frames.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

/// Things of an office, in the map frame; no two pairs are equally far apart.
const std::vector<std::pair<std::string, Vec2>> kThings{
    {"basket", {0.7, 4.2}}, {"basket", {3.6, 3.4}}, {"basket", {4.8, 0.6}}, {"basket", {7.4, 5.2}},
    {"trash", {1.3, 2.1}},  {"trash", {2.9, 1.2}},  {"trash", {5.5, 2.7}},  {"trash", {6.3, 4.4}},
    {"trash", {2.2, 5.1}},  {"trash", {4.1, 4.9}}};

Vec2 into(const Pose2& frame, const Vec2& in_map_m) {
  return rotated(in_map_m - frame.position_m, -frame.heading_rad);
}

msg::Sighting sighting(const std::string& object_class, const Vec2& at_m) {
  msg::Sighting result;
  result.object_class = object_class;
  result.x_m = at_m.x();
  result.y_m = at_m.y();
  result.variance_xx = result.variance_yy = 4e-4;
  result.range_m = 3;
  return result;
}

class FramesTest : public testing::Test {
 protected:
  /// What `robot` remembers of all things if its odom frame lies at `frame`.
  void remember(const std::string& robot, const Pose2& frame) {
    msg::Sightings seen;
    seen.robot = robot;
    for (const auto& [object_class, at_m] : kThings)
      seen.items.push_back(sighting(object_class, into(frame, at_m)));
    for (int i = 0; i < 5; ++i) memories[robot].see(seen, now);
  }
  void align(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      now += 1s;
      frames.align(memories, now);
    }
  }
  void expect_at(const std::string& robot, const Pose2& frame, double within_m, double within_rad) {
    const Pose2& found = frames.of(robot).pose;
    EXPECT_LT((found.position_m - frame.position_m).norm(), within_m);
    EXPECT_LT(std::abs(wrap_angle(found.heading_rad - frame.heading_rad)), within_rad);
  }

  Frames frames;
  std::map<std::string, RobotMemory> memories;
  Time now{1s};
};

TEST_F(FramesTest, DriftIsCorrectedThoughAFewThingsAreOutOfPlace) {
  const Pose2 drifted{{0.20, -0.15}, 0.10};
  remember("ganymede", {});
  remember("io", drifted);
  // io mistakes two shadows for trash, and one can was moved.
  memories["io"].landmarks()[4].place.mean_m += Vec2(0.5, 0.2);
  memories["io"].landmarks().push_back(
      {"trash", {{3.1, 1.4}, 4e-4 * Mat2::Identity()}, 1, now, now});
  align(20);
  expect_at("ganymede", {}, 1e-9, 1e-9);
  expect_at("io", drifted, 0.05, 0.02);
}

TEST_F(FramesTest, AFrameThatBeganAtAnUnknownPlaceIsFound) {
  const Pose2 elsewhere{{3.4, 1.5}, 2.1};
  remember("ganymede", {});
  remember("io", elsewhere);
  memories["io"].landmarks()[9].place.mean_m += Vec2(0.9, 0.4);
  align(12);
  expect_at("io", elsewhere, 0.05, 0.02);
}

TEST_F(FramesTest, TooFewSharedThingsMoveNothing) {
  remember("ganymede", {});
  auto& own = memories["io"].landmarks();
  remember("io", {{3, 1}, 1});
  own.resize(5);
  align(12);
  expect_at("io", {}, 1e-9, 1e-9);
}

TEST_F(FramesTest, MeetingsAloneAlignTwoRobotsWhoseStartIsKnownRoughly) {
  const Pose2 drifted{{0.15, 0.10}, -0.12};
  msg::Sightings lone;
  lone.items = {sighting("trash", {9, 9})};
  memories["ganymede"].see(lone, now);
  memories["io"].see(msg::Sightings{}, now);
  Random random(7);
  std::uint64_t number = 0;
  for (double along_m = 0; along_m < 3; along_m += 0.2) {
    const Vec2 io_m{1 + along_m, 2 + 0.3 * along_m * along_m};
    ++number;
    frames.note({"ganymede", "io", io_m + 0.02 * Vec2(random.normal(), random.normal()),
                 into(drifted, io_m), number, now});
    // Cameras do not tell robots apart: the same sighting may have been of callisto, who was away.
    frames.note({"ganymede", "callisto", io_m, {-4, -4 + along_m}, number, now});
  }
  align(20);
  expect_at("io", drifted, 0.08, 0.04);
}

TEST_F(FramesTest, TheCovarianceGrowsWithDriftAndShrinksWithFits) {
  remember("ganymede", {});
  memories["io"].see(msg::Sightings{}, now);
  const double at_start = frames.of("io").covariance.trace();
  align(30);
  const double drifted = frames.of("io").covariance.trace();
  EXPECT_GT(drifted, at_start);
  now += 1s;
  remember("io", {});
  align(10);
  EXPECT_LT(frames.of("io").covariance.trace(), at_start / 4);
}

}  // namespace
}  // namespace galilean::monitor
