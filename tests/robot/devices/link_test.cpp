// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/robot/devices/board_on_a_pipe.h"

namespace galilean::robot {
namespace {

constexpr int kTimeout_ms = 500;

class Link : public testing::Test {
 protected:
  BoardOnAPipe robot;
  MicrocontrollerLink& link = robot.link;
};

TEST_F(Link, GreetsGivesParametersAndIsReadyWithinMilliseconds) {
  EXPECT_FALSE(link.healthy());
  EXPECT_NE(link.problem(), "");
  robot.run(50);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.problem(), "");
}

TEST_F(Link, TellsSwitchesBeamAndGripper) {
  robot.bench().bumpers = 0b10000100;
  robot.bench().beam_broken = true;
  link.command_gripper(GripperCommand::kClose);
  robot.run(100);
  EXPECT_EQ(link.status().bumpers, 0b10000100);
  EXPECT_TRUE(link.status().beam_broken);
  EXPECT_FALSE(link.status().gripper_closed);
  robot.run(500);
  EXPECT_TRUE(link.status().gripper_closed);
  link.command_gripper(GripperCommand::kOpen);
  robot.run(60);
  EXPECT_FALSE(link.status().gripper_closed);
}

TEST_F(Link, DrivesInMetresAndSeconds) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.2}, 3000);
  EXPECT_NEAR(link.status().left_speed_mps, 0.2, 0.01);
  EXPECT_NEAR(link.status().left_travel_m, 0.6, 0.06);
  EXPECT_NEAR(link.status().left_travel_m, link.status().right_travel_m, 0.002);
}

TEST_F(Link, ALostLineIsNamedStopsTheWheelsAndComesBack) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  const auto travel_before_m = link.status().left_travel_m;
  robot.pipe.connect(false);
  robot.keep_driving({.speed_mps = 0.3}, kTimeout_ms + 500);
  EXPECT_FALSE(link.healthy());
  EXPECT_NE(link.problem().find("bench line"), std::string::npos) << link.problem();
  EXPECT_NEAR(robot.bench().left.speed_counts_s(), 0, 5);
  robot.pipe.connect(true);
  robot.run(100);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.problem(), "");
  EXPECT_EQ(link.status().epoch, 0u);
  EXPECT_GT(link.status().left_travel_m, travel_before_m);
  EXPECT_EQ(robot.bench().outputs.left_pwm, 0) << "an old command drove on";
}

TEST_F(Link, AnotherProgramsTimeoutHoldsFromThenOn) {
  robot.run(50);
  link.set_timeout(std::chrono::milliseconds(100));
  robot.board_runs = false;
  robot.run(200);
  EXPECT_FALSE(link.healthy());
  robot.board_runs = true;
  robot.run(500);
  ASSERT_TRUE(link.healthy());
  link.set_timeout(std::chrono::seconds(2));
  robot.board_runs = false;
  robot.run(kTimeout_ms + 500);
  EXPECT_TRUE(link.healthy());
}

TEST_F(Link, ASilentBoardIsNamedAndComesBack) {
  robot.run(50);
  robot.board_runs = false;
  robot.run(kTimeout_ms + 100);
  EXPECT_FALSE(link.healthy());
  EXPECT_NE(link.problem().find("does not answer"), std::string::npos) << link.problem();
  robot.board_runs = true;
  robot.run(200);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.status().epoch, 0u);
}

TEST_F(Link, ABoardThatWasResetIsGivenItsParametersAgainAndTravelBeginsAnew) {
  link.command_gripper(GripperCommand::kClose);
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  EXPECT_GT(link.status().left_travel_m, 0.2);
  robot.power_up();
  robot.run(100);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.status().epoch, 1u);
  EXPECT_EQ(link.status().left_travel_m, 0);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  EXPECT_NEAR(link.status().left_speed_mps, 0.3, 0.02);
  EXPECT_TRUE(link.status().gripper_closed) << "the gripper's command was forgotten";
}

TEST_F(Link, WheelsStandWhenTheControlLoopHangs) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  robot.run(kTimeout_ms + 500);
  EXPECT_TRUE(link.healthy());
  EXPECT_NEAR(robot.bench().left.speed_counts_s(), 0, 5);
}

/// Every tick gives a command at 20 Hz. The line is blocked for so long, and then everything that
/// the robot wrote arrives at once.
class BlockedLine : public Link, public testing::WithParamInterface<int> {
 protected:
  /// Returns the types of the frames that wait on the line, oldest first.
  std::vector<firmware::MessageType> waiting() {
    std::vector<firmware::MessageType> types;
    std::array<std::uint8_t, 1024> bytes;
    const auto count = robot.pipe.board_end().read(bytes);
    firmware::FrameDecoder decoder;
    for (std::size_t i = 0; i < count; ++i)
      if (decoder.push(bytes[i]))
        types.push_back(static_cast<firmware::MessageType>(decoder.frame().type));
    return types;
  }
};

TEST_P(BlockedLine, FewDrivesAreAheadOfAStop) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  robot.board_reads = false;
  robot.keep_driving({.speed_mps = 0.3}, GetParam());
  robot.drive.stop();
  robot.run(4);
  const auto types = waiting();
  EXPECT_LE(std::ranges::count(types, firmware::MessageType::kDrive), 12);
  const bool greets = std::ranges::count(types, firmware::MessageType::kHello) > 0;
  const auto motion = std::ranges::find(types, firmware::MessageType::kStop);
  EXPECT_TRUE(motion != types.end() || greets) << "it neither stops nor begins anew";
  EXPECT_EQ(std::find(motion, types.end(), firmware::MessageType::kDrive), types.end());
}

TEST_P(BlockedLine, NothingOldMovesTheRobotWhenItIsFree) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  robot.board_reads = false;
  robot.keep_driving({.speed_mps = 0.3}, GetParam());
  robot.run(500);
  const auto stood_at = robot.bench().left.counts();
  robot.board_reads = true;
  robot.run(1000);
  EXPECT_NEAR(robot.bench().left.counts(), stood_at, 60) << "more than about a centimetre";
  EXPECT_TRUE(link.healthy()) << link.problem();
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  EXPECT_NEAR(link.status().left_speed_mps, 0.3, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Milliseconds, BlockedLine, testing::Values(20, 60, 200, 480, 600, 4500));

TEST_F(Link, OneLostFrameIsNotFelt) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  for (int i = 0; i < 100; ++i) {
    robot.drive.drive({.speed_mps = 0.3});
    robot.board_reads = i % 2 != 0;
    robot.run_traffic(1);
    std::array<std::uint8_t, 64> lost;
    if (!robot.board_reads) {
      EXPECT_GT(robot.pipe.board_end().read(lost), 0u);
    }
    robot.board_reads = true;
    for (int ms = 0; ms < 49; ++ms) {
      robot.run_traffic(1);
      ASSERT_GT(robot.bench().outputs.left_pwm, 0) << i << ", " << ms << " ms";
    }
  }
}

TEST_F(Link, AProcessThatStoodStillForgetsWhatItOrderedBefore) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 500);
  robot.drive.drive({.speed_mps = 0.3});
  robot.stand_still(400);
  const auto stood_at = robot.bench().left.counts();
  robot.run(500);
  EXPECT_NEAR(robot.bench().left.counts(), stood_at, 2);
  EXPECT_TRUE(link.healthy());
}

TEST_F(Link, AResetThatIsNoticedByItsBootCountAlone) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  const auto epoch = link.status().epoch;
  // The board is back before its next status, and its uptime is longer than before.
  robot.power_up(5000);
  robot.run(100);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.status().epoch, epoch + 1);
  EXPECT_EQ(link.status().left_travel_m, 0);
}

TEST_F(Link, AnotherBoardOnTheLineIsNoticedByItsNameAlone) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  EXPECT_GT(link.status().left_travel_m, 0.2);
  const auto epoch = link.status().epoch;
  robot.pipe.connect(false);
  robot.run(100);
  // It was started as often as the one before, and has run for longer.
  robot.replace_board(500000);
  robot.pipe.connect(true);
  robot.run(100);
  EXPECT_TRUE(link.healthy());
  EXPECT_EQ(link.status().epoch, epoch + 1);
  EXPECT_EQ(link.status().left_travel_m, 0) << "the other board's encoders are no travel";
}

TEST_F(Link, StopIsRepeatedUntilTheMotorsAreOff) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 500);
  robot.drive.stop();
  robot.pipe.connect(false);
  robot.link.pump(Time{std::chrono::milliseconds(10000)});
  robot.pipe.connect(true);
  robot.run(10);
  robot.drive.stop();
  robot.run(100);
  EXPECT_EQ(robot.bench().outputs.left_pwm, 0);
}

TEST_F(Link, AnotherProgramsParametersTakeEffectWithoutAGap) {
  robot.run(50);
  robot.keep_driving({.speed_mps = 0.3}, 1000);
  robot.settings.forward_velocity_ticks_s = 50;
  robot.settings.ticks_per_m = 400;
  const auto travel_m = link.status().left_travel_m;
  robot.drive.configure(robot.settings);
  for (int i = 0; i < 50; ++i) {
    robot.keep_driving({.speed_mps = 0.3}, 20);
    ASSERT_TRUE(link.healthy());
  }
  EXPECT_NEAR(robot.bench().left.speed_counts_s(), 50 * 16, 40);
  EXPECT_NEAR(link.status().left_travel_m, travel_m + 0.14, 0.05);
}

TEST_F(Link, ParametersThatTheBoardRefusesAreTold) {
  robot.settings.forward_velocity_ticks_s = -5;
  robot.drive.configure(robot.settings);
  robot.run(100);
  EXPECT_FALSE(link.healthy());
  EXPECT_NE(link.problem().find("motor_drive"), std::string::npos) << link.problem();
  robot.settings.forward_velocity_ticks_s = 100;
  robot.drive.configure(robot.settings);
  robot.run(100);
  EXPECT_TRUE(link.healthy());
}

TEST(LinkWithAnotherBoard, NamesBothVersions) {
  BytePipe pipe("bench line");
  MicrocontrollerLink link(pipe.robot_end(), CommPortSettings{});
  std::array<std::uint8_t, firmware::kMaxEncoded> bytes;
  const std::array<std::uint8_t, 5> reply{9, 1, 2, 3, 4};
  const auto type = static_cast<std::uint8_t>(firmware::MessageType::kHelloReply);
  const auto size = firmware::encode({type, 1, reply}, bytes);
  link.pump(Time{});
  pipe.board_end().write(std::span(bytes).first(size));
  link.pump(Time{std::chrono::milliseconds(1)});
  link.sense(Time{std::chrono::milliseconds(2)});
  EXPECT_FALSE(link.healthy());
  EXPECT_NE(link.problem().find("version 9"), std::string::npos) << link.problem();
  EXPECT_NE(link.problem().find("version 2"), std::string::npos) << link.problem();
}

TEST(LinkOnANoisyLine, KeepsDrivingAndTakesNothingFalse) {
  BoardOnAPipe robot;
  robot.run(50);
  std::uint32_t noise = 1;
  for (int i = 0; i < 200; ++i) {
    std::array<std::uint8_t, 12> garbage;
    for (auto& byte : garbage)
      byte = static_cast<std::uint8_t>((noise = noise * 1664525 + 1013904223) >> 24);
    robot.pipe.robot_end().write(garbage);
    robot.pipe.board_end().write(garbage);
    robot.keep_driving({.speed_mps = 0.3}, 20);
    ASSERT_TRUE(robot.link.healthy());
    ASSERT_EQ(robot.link.status().bumpers, 0);
    ASSERT_EQ(robot.link.status().epoch, 0u);
  }
  EXPECT_NEAR(robot.bench().left.speed_counts_s(), 0.3 * 325 * 16, 60);
}

}  // namespace
}  // namespace galilean::robot
