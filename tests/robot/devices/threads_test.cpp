#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "robot/devices/pump_thread.h"
#include "tests/robot/devices/board_on_a_pipe.h"

namespace galilean::robot {
namespace {

TEST(PumpThread, PumpsUntilItIsEnded) {
  const SteadyClock clock;
  std::atomic<int> pumped{0};
  std::promise<void> often;
  {
    const PumpThread thread(clock, std::chrono::microseconds(100), [&](Time) {
      if (++pumped == 10) often.set_value();
    });
    often.get_future().wait();
  }
  const int at_the_end = pumped;
  std::this_thread::yield();
  EXPECT_EQ(pumped, at_the_end);
}

// What the sanitizer is to look at: the I/O side in one thread, the control loop in another.
TEST(LinkInTwoThreads, ControlLoopAndTrafficNeverMeet) {
  BoardOnAPipe robot;
  robot.run(50);
  std::atomic<bool> stop{false};
  std::jthread traffic([&] {
    while (!stop) robot.run_traffic(1);
  });
  std::uint32_t healthy = 0;
  for (int i = 0; i < 20000; ++i) {
    robot.drive.drive({.speed_mps = 0.2});
    robot.link.command_gripper(i % 2 ? GripperCommand::kOpen : GripperCommand::kClose);
    robot.link.sense(robot.link.status().received);
    healthy += robot.link.healthy();
    ASSERT_EQ(robot.link.problem(), "");
  }
  stop = true;
  EXPECT_EQ(healthy, 20000u);
}

}  // namespace
}  // namespace galilean::robot
