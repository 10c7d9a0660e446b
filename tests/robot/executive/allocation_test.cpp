// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/snapshot.h"
#include "robot/telemetry/image_tap.h"
#include "tests/robot/count_allocations.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

class Allocations : public testing::Test {
 protected:
  Allocations() : robot(1, {&snapshots, &images}) {
    for (ImageChannel channel = 0; channel < images.channels().size(); ++channel)
      images.want(channel, true);
  }
  /// Allocations and releases of so many ticks.
  long of_ticks(int times) {
    long allocations = 0;
    for (int i = 0; i < times; ++i) {
      robot.clock.advance(std::chrono::milliseconds(50));
      if (i % 2) ++robot.camera.picture.number;
      robot.port.next.bumpers = i % 40 == 3 ? 1 : 0;
      robot.port.next.beam_broken = i % 60 > 30;
      robot.port.next.gripper_closed = i % 60 > 35;
      robot.port.next.left_travel_m += 0.01;
      {
        const AllocationCount count;
        robot.executive->tick();
        allocations += count.so_far();
      }
      while (snapshots.next_event()) {
      }
    }
    return allocations;
  }

  SnapshotTap snapshots;
  ImageTap images{test_components().catalog()};
  TestRobot robot;
};

TEST_F(Allocations, NoTickOfTheOfficeProgramAllocates) {
  robot.events.events.reserve(100000);
  paint_office(robot.camera.picture);
  ASSERT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  EXPECT_EQ(of_ticks(2000), 0);
  EXPECT_GT(robot.executive->transitions(), 10U);
}

TEST_F(Allocations, NoTickThatSwapsOrConfirmsAllocatesOrDestroys) {
  ASSERT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  EXPECT_EQ(of_ticks(10), 0);
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(robot.executive->load(
        shipped_program(i % 2 ? "office_cleanup.bhdl" : "sit_and_spin.bhdl")));
    EXPECT_EQ(of_ticks(i % 3 ? 5 : 250), 0);
  }
}

}  // namespace
}  // namespace galilean::robot
