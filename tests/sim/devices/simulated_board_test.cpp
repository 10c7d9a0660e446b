// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/simulated_board.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "robot/devices/byte_pipe.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "tests/sim/scenes.h"
#include "tests/temporary_folder.h"

namespace galilean::sim {
namespace {

TEST(BootMemory, CountsOnWhereTheSimulatorBeforeEnded) {
  const TemporaryFolder folder;
  const auto file = folder / "boards" / "io.boots";
  for (std::uint16_t start = 1; start <= 3; ++start) {
    BootMemory memory(file);
    EXPECT_EQ(memory.count_start(), start);
    EXPECT_EQ(memory.problem(), "");
  }
  std::ofstream(file) << 65535 << "\n";
  BootMemory full(file);
  EXPECT_EQ(full.count_start(), 1);
  EXPECT_EQ(full.count_start(), 2);
}

TEST(BootMemory, SaysWhatIsNoCountAndMendsIt) {
  const TemporaryFolder folder;
  const auto file = folder / "io.boots";
  for (const char* text : {"", "\n", "x", "-1", "65536", "12 3", "7\n\n", "1234567890123"}) {
    std::ofstream(file) << text;
    BootMemory memory(file);
    EXPECT_NE(memory.problem().find(file.string()), std::string::npos) << text;
    EXPECT_EQ(memory.count_start(), 1) << text;
    BootMemory next(file);
    EXPECT_EQ(next.problem(), "") << text;
    EXPECT_EQ(next.count_start(), 2) << text;
  }
}

TEST(BootMemory, SaysThatItCannotKeepTheCountAndCountsOn) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "no folder";
  BootMemory memory(folder / "file" / "io.boots");
  EXPECT_EQ(memory.count_start(), 1);
  EXPECT_EQ(memory.count_start(), 2);
  EXPECT_NE(memory.problem().find("cannot be written"), std::string::npos) << memory.problem();
}

/// A robot's devices and its board in the simulated world, on a stepped clock.
class SimulatedBoardTest : public testing::Test {
 protected:
  void run_for(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ms += 10) {
      const Time now{std::chrono::milliseconds(now_ms)};
      link.pump(now);
      link.sense(now);
      board.update(now_ms);
      world->step();
      now_ms += 10;
    }
  }
  void keep_driving(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ms += 50) {
      drive.drive({.speed_mps = 0.3});
      run_for(50);
    }
  }
  [[nodiscard]] double speed_mps() const {
    const b2Vec2 velocity = world->robot(0).body().GetLinearVelocity();
    return std::hypot(velocity.x, velocity.y);
  }

  std::unique_ptr<World> world = world_of(bare_floor());
  robot::BytePipe line{"bench line"};
  SimulatedBoard board{world->robot(0), line.board_end(), "io"};
  robot::MicrocontrollerLink link{line.robot_end(), {}};
  robot::WheelDrive drive{link, {}};
  std::uint32_t now_ms = 0;
};

TEST_F(SimulatedBoardTest, ARestartBetweenTwoFramesIsNoticed) {
  run_for(200);
  ASSERT_TRUE(link.healthy());
  for (std::uint32_t restarts = 1; restarts <= 3; ++restarts) {
    keep_driving(500);
    EXPECT_GT(link.status().left_travel_m, 0.05);
    board.set_power(false);
    board.set_power(true);
    run_for(400);
    EXPECT_TRUE(link.healthy()) << link.problem();
    EXPECT_EQ(link.status().epoch, restarts);
    EXPECT_LT(link.status().left_travel_m, 0.04) << "travel did not begin anew";
    EXPECT_LT(speed_mps(), 0.002) << "an old command drove on";
  }
}

TEST_F(SimulatedBoardTest, WithoutPowerTheMotorsAreShortedAndTheLineIsSilent) {
  run_for(200);
  keep_driving(1000);
  ASSERT_GT(speed_mps(), 0.25);
  board.set_power(false);
  keep_driving(1000);
  EXPECT_LT(speed_mps(), 0.002);
  EXPECT_FALSE(world->robot(0).powered());
  EXPECT_FALSE(link.healthy());
  board.set_power(true);
  run_for(500);
  EXPECT_TRUE(link.healthy()) << link.problem();
  EXPECT_LT(speed_mps(), 0.002) << "an old command drove on";
  keep_driving(1000);
  EXPECT_GT(speed_mps(), 0.25);
}

}  // namespace
}  // namespace galilean::sim
