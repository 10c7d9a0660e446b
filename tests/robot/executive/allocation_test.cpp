// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <cstdlib>
#include <memory>

#include "robot/executive/snapshot.h"
#include "robot/inputs/inputs_tap.h"
#include "robot/robot_devices.h"
#include "robot/telemetry/image_tap.h"
#include "tests/robot/count_allocations.h"
#include "tests/robot/devices/bench_robot.h"
#include "tests/robot/executive/branching_robot.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

/// Keeps the compiler from leaving out what takes memory for nothing.
void use(void* room) {
  asm volatile("" : : "g"(room) : "memory");
}

template <class Work>
long allocations_of(Work work) {
  const AllocationCount count;
  work();
  return count.so_far();
}

TEST(AllocationCount, CountsWhateverTakesMemory) {
  struct alignas(64) Wide {
    double numbers[8];
  };
  EXPECT_EQ(allocations_of([] {}), 0);
  // A sanitizer's realloc is two.
  EXPECT_GE(allocations_of([] {
              void* room = std::malloc(10);
              use(room);
              room = std::realloc(room, 100'000);
              use(room);
              std::free(room);
            }),
            3);
  EXPECT_EQ(allocations_of([] { use(std::make_unique<int>(1).get()); }), 2);
  EXPECT_EQ(allocations_of([] { use(std::make_unique<Wide>().get()); }), 2);
  EXPECT_EQ(allocations_of([] { use(std::unique_ptr<int>(new (std::nothrow) int).get()); }), 2);
  EXPECT_EQ(allocations_of([] { use(Eigen::VectorXd(100).data()); }), 2);
}

class Allocations : public testing::Test {
 protected:
  Allocations() : robot(1, {&snapshots, &images, &inputs}) {
    for (ImageChannel channel = 0; channel < images.channels().size(); ++channel)
      images.want(channel, true);
  }
  /// Allocations and releases of so many ticks.
  long of_ticks(int times) {
    long allocations = 0;
    for (int i = 0; i < times; ++i) {
      robot.clock.advance(std::chrono::milliseconds(50));
      if (i % 2) ++robot.camera.picture.number;
      if (i % 50 == 0) inputs.want_memory();
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
      for (TickRecord record; inputs.take(record);) {
      }
    }
    return allocations;
  }

  SnapshotTap snapshots;
  ImageTap images{test_components().catalog()};
  InputsTap inputs;
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

TEST(AllocationsOfBreaks, NoTickThatTakesThemOverStopsStepsOrWaitsAllocates) {
  SnapshotTap tap;
  BranchingRobot robot({&tap});
  journal.reserve(10000);
  Breaks& breaks = robot.executive->breaks();
  const std::string long_name(200, 'x');
  int stops = 0, waits = 0;
  for (int i = 0; i < 300; ++i) {
    const BreakKind kind = i % 3 == 0 ? BreakKind::kLock : BreakKind::kStop;
    ASSERT_TRUE(breaks.set({{{"", "grab"}, kind}, {{long_name, std::to_string(i % 8)}, kind}}));
    if (i % 4 == 0)
      static_cast<void>(breaks.let_through({{"", "grab"}}, robot.executive->present_state()));
    if (i % 5 == 0) breaks.clear();
    static_cast<void>(robot.executive->step());
    const unsigned bumper = robot.state() == "wander" ? 0 : 2;
    robot.press(bumper);
    {
      const AllocationCount count;
      robot.tick(2);
      EXPECT_EQ(count.so_far(), 0) << i;
    }
    robot.press(bumper, false);
    stops += robot.executive->held();
    waits += robot.events.standstill.wait.condition != Event::kNone;
    while (tap.next_event()) {
    }
  }
  EXPECT_GT(stops, 20);
  EXPECT_GT(waits, 20);
}

TEST(AllocationsOfTheDevices, NoTickOverARealLineAndARingOfPicturesAllocates) {
  BenchRobot robot;
  ASSERT_TRUE(robot.executive.load(shipped_program("office_cleanup.bhdl")));
  robot.run_ticks(10);
  ASSERT_TRUE(robot.devices.devices().comm_port.healthy());
  ASSERT_TRUE(robot.devices.devices().frame_grabber.healthy());
  EXPECT_EQ(robot.run_ticks(500), 0);
  ASSERT_TRUE(robot.executive.load(shipped_program("sit_and_spin.bhdl")));
  EXPECT_EQ(robot.run_ticks(100), 0) << "takes another program's settings over";
  robot.line.connect(false);
  EXPECT_EQ(robot.run_ticks(60), 0) << "loses its board";
  EXPECT_FALSE(robot.devices.devices().comm_port.healthy());
  robot.line.connect(true);
  EXPECT_EQ(robot.run_ticks(60), 0) << "finds it again";
  EXPECT_TRUE(robot.devices.devices().comm_port.healthy());
}

}  // namespace
}  // namespace galilean::robot
