// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/snapshot.h"

#include <algorithm>

#include "robot/telemetry/image_tap.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

TEST(SnapshotTap, TheSnapshotIsAtLeastAsNewAsTheEvents) {
  SnapshotTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  robot.tick(3);
  robot.press(0);
  robot.tick();
  std::optional<Event> transition;
  while (const auto event = tap.next_event())
    if (event->kind == Event::Kind::kTransition) transition = event;
  ASSERT_TRUE(transition);
  ASSERT_TRUE(tap.take());
  EXPECT_GE(tap.newest().tick, transition->tick);
  EXPECT_EQ(tap.newest().state, transition->to_state);
  EXPECT_FALSE(tap.take());
}

TEST(SnapshotTap, HoldsEveryVariableInTheOrderOfTheDescription) {
  SnapshotTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  robot.port.next.bumpers = 4;
  robot.tick();
  ASSERT_TRUE(tap.take());
  const Snapshot& snapshot = tap.newest();
  const auto description = robot.executive->description(snapshot.program);
  ASSERT_EQ(snapshot.variables.size(), description->variables.size());
  bool found = false;
  for (std::size_t i = 0; i < snapshot.variables.size(); ++i) {
    if (description->variables[i].name != "bumpers") continue;
    found = true;
    EXPECT_TRUE(snapshot.variables[i].valid);
    EXPECT_EQ(snapshot.variables[i].values[0], 4);
  }
  EXPECT_TRUE(found);
}

// The tap has three snapshots, which it fills in turn: each must get the speeds anew.
TEST(SnapshotTap, TellsTheSpeedsOfAProgramWithoutAShaftAfterOneWithAShaft) {
  SnapshotTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load("variables: shaft: name: \"shaft\" end state: name: \"a\" end"));
  robot.port.next.left_speed_mps = 0.1;
  robot.port.next.right_speed_mps = 0.3;
  robot.tick(4);
  ASSERT_TRUE(tap.take());
  EXPECT_NEAR(tap.newest().speed_mps, 0.2, 1e-9);
  EXPECT_NEAR(tap.newest().turn_rate_radps, 0.2 / 0.4, 1e-9);
  ASSERT_TRUE(robot.load("state: name: \"b\" end"));
  robot.port.next.left_speed_mps = robot.port.next.right_speed_mps = -0.1;
  for (int i = 0; i < 4; ++i) {
    robot.tick();
    ASSERT_TRUE(tap.take());
    EXPECT_NEAR(tap.newest().speed_mps, -0.1, 1e-9);
    EXPECT_NEAR(tap.newest().turn_rate_radps, 0, 1e-9);
  }
}

TEST(SnapshotTap, LosesNoEventOfManyTicksThatNobodyReads) {
  SnapshotTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load(R"(
variables: bits: name: "bumpers" end
perceptual_schemas: bumper_scanner: name: "scan" bits_variable: "bumpers" end end
states:
  state: name: "a" perceptual_schemas: "scan" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "b" end end
  state: name: "b" perceptual_schemas: "scan" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "a" end end
end
)"));
  robot.press(0);
  robot.tick(200);
  std::uint64_t number = 0;
  while (const auto event = tap.next_event())
    if (event->kind == Event::Kind::kTransition) {
      EXPECT_EQ(event->number, ++number);
    }
  EXPECT_EQ(number, 200U);
  EXPECT_EQ(tap.lost_events(), 0U);
}

ImageChannel channel_named(const ImageTap& images, const std::string& name) {
  const auto& names = images.channels();
  return static_cast<ImageChannel>(std::ranges::find(names, name) - names.begin());
}

TEST(ImageTap, HasTheCameraAndThePicturesThatTheCatalogNames) {
  EXPECT_EQ(ImageTap(Catalog{}).channels(), std::vector<std::string>{"camera"});
  EXPECT_EQ(ImageTap(test_components().catalog()).channels(),
            (std::vector<std::string>{"camera", "superred", "supergreen", "superblue", "dark"}));
}

TEST(ImageTap, HandsOutOnlyWhatIsWantedAndTenASecond) {
  ImageTap images(test_components().catalog());
  const ImageChannel superred = channel_named(images, "superred");
  TestRobot robot(1, {&images});
  paint_office(robot.camera.picture);
  ASSERT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  robot.tick(4);
  EXPECT_FALSE(images.take(kCameraChannel));
  images.want(kCameraChannel, true);
  images.want(superred, true);
  int cameras = 0;
  int reds = 0;
  for (int i = 0; i < 20; ++i) {
    ++robot.camera.picture.number;
    robot.tick();
    cameras += images.take(kCameraChannel);
    reds += images.take(superred);
  }
  EXPECT_EQ(cameras, 10);
  EXPECT_EQ(reds, 10);
  EXPECT_FALSE(images.take(channel_named(images, "dark")));
  EXPECT_EQ(images.newest(kCameraChannel).pixels[0], 150);
  const auto& red = images.newest(superred).pixels;
  EXPECT_GT(red[125 * Image::kWidth + 170], 100) << "the can";
  EXPECT_EQ(red[10], 0) << "the floor";
}

}  // namespace
}  // namespace galilean::robot
