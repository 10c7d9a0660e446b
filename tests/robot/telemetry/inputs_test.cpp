// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/robot/telemetry/telemetry_robot.h"

// What ticks read, as a recorder gets it.

namespace galilean::robot {
namespace {

TEST(InputsPublisher, AReaderThatComesAtTheStartGetsEveryTickFromTheFirstOn) {
  constexpr std::uint64_t kTicks = 40;
  TelemetryRobot io("t_inputs");
  ASSERT_TRUE(io.robot.load(kWaits));
  io.robot.tick(10);
  auto inputs = io.mailbox<msg::TickInputs>("inputs");
  for (std::uint64_t i = 10; i < kTicks; ++i) {
    ++io.robot.camera.picture.number;
    io.robot.tick();
    ASSERT_TRUE(inputs.wait_for([&](const auto& each) { return each.tick == i + 1; }));
  }
  const auto all = inputs.all();
  ASSERT_EQ(all.size(), kTicks);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].tick, i + 1);
    EXPECT_EQ(all[i].picture.empty(), i < 10) << i;
    EXPECT_EQ(all[i].outcome.state, "wait");
  }
  ASSERT_EQ(all[0].program.size(), 1U);
  EXPECT_EQ(all[0].program[0].files[0].text, kWaits);
  EXPECT_EQ(all[0].robot, "t_inputs");
  EXPECT_EQ(all[0].seed, 1U);
}

}  // namespace
}  // namespace galilean::robot
