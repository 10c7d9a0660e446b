// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>

#include "robot/devices/frame_grabber.h"
#include "robot/devices/pump_thread.h"
#include "tests/robot/devices/board_on_a_pipe.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

constexpr Duration kPause = std::chrono::microseconds(100);

TEST(PumpThread, PumpsUntilItIsEnded) {
  const SteadyClock clock;
  std::atomic<int> pumped{0};
  std::promise<void> often;
  {
    const PumpThread thread(
        clock, kPause,
        [&](Time) {
          if (++pumped == 10) often.set_value();
        },
        [](const std::string& why) { ADD_FAILURE() << why; });
    often.get_future().wait();
  }
  const int at_the_end = pumped;
  std::this_thread::yield();
  EXPECT_EQ(pumped, at_the_end);
}

/// A camera whose driver throws, until it is mended.
class BrokenCamera final : public FrameSource {
 public:
  bool grab(Frame&, Time) override {
    if (broken) throw std::runtime_error("the driver is gone");
    return true;
  }
  std::string problem() const override { return ""; }

  std::atomic<bool> broken{true};
};

TEST(PumpThread, ACameraThatThrowsIsMissingUntilItWorksAgain) {
  const SteadyClock clock;
  BrokenCamera source;
  CameraGrabber grabber(source, {});
  std::promise<void> failed;
  const PumpThread thread(
      clock, kPause, [&](Time now) { grabber.pump(now); },
      [&](const std::string& why) {
        grabber.fail(why);
        failed.set_value();
      });
  failed.get_future().wait();
  grabber.sense(clock.now());
  EXPECT_FALSE(grabber.healthy());
  EXPECT_THAT(grabber.problem(), HasSubstr("the driver is gone"));
  source.broken = false;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  for (; !grabber.healthy() && std::chrono::steady_clock::now() < end; std::this_thread::yield())
    grabber.sense(clock.now());
  EXPECT_TRUE(grabber.healthy());
  EXPECT_EQ(grabber.problem(), "");
}

TEST(CameraGrabber, IsMissingFromItsFailureOnHoweverFreshItsPictureIs) {
  BrokenCamera source;
  source.broken = false;
  CameraGrabber grabber(source, {});
  const Time now{std::chrono::seconds(1)};
  grabber.pump(now);
  grabber.sense(now);
  EXPECT_TRUE(grabber.healthy());
  grabber.fail("the driver is gone");
  grabber.sense(now);
  EXPECT_FALSE(grabber.healthy());
  EXPECT_THAT(grabber.problem(), HasSubstr("frame_grabber"));
}

TEST(MicrocontrollerLink, IsMissingFromItsFailureOnUntilItIsPumpedAgain) {
  BoardOnAPipe robot;
  robot.run(100);
  EXPECT_TRUE(robot.link.healthy());
  robot.link.fail("out of memory");
  robot.link.sense(robot.link.status().received);
  EXPECT_FALSE(robot.link.healthy());
  EXPECT_FALSE(robot.drive.healthy());
  EXPECT_THAT(robot.link.problem(), HasSubstr("bench line cannot be used (out of memory)"));
  robot.run(100);
  EXPECT_TRUE(robot.link.healthy());
  EXPECT_EQ(robot.link.problem(), "");
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
