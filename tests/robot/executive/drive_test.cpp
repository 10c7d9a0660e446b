// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

/// Drives in "go" while no bumper is pressed; "rest" has no schema that drives.
std::string driving_program(const std::string& devices, const std::string& motor_schemas) {
  return devices + R"(
output_devices: motor_drive: timeout: 0.4 end end
variables: bits: name: "bumpers" end
perceptual_schemas: bumper_scanner: name: "scan" bits_variable: "bumpers" end end
motor_schemas:
  ahead: name: "ahead" speed: 0.2 end
  note_motor: name: "note" end
end
states:
  state: name: "go" perceptual_schemas: "scan" end motor_schemas: )" +
         motor_schemas + R"( end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "rest" end
  end
  state: name: "rest" perceptual_schemas: "scan" end motor_schemas: "note" end end
end
)";
}

TEST(Drive, HoldStopsTheMotorsWhileTheSchemasRun) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_program("", "\"ahead\" \"note\"")));
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  robot.executive->hold();
  journal.clear();
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_EQ(journal.size(), 1U);
  robot.executive->resume();
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.drive.last.speed_mps, 0.2);
}

TEST(Drive, OutOfServiceTheMotorsStandStillWhoeverResumes) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_program("", "\"ahead\" \"note\"")));
  robot.tick();
  robot.executive->decommission();
  robot.executive->resume();
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
  robot.executive->commission();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

TEST(Drive, AStateThatDoesNotDriveStopsTheMotorsAtOnce) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_program("", "\"ahead\"")));
  robot.tick();
  robot.press(0);
  robot.tick();
  EXPECT_EQ(robot.state(), "rest");
  EXPECT_FALSE(robot.drive.moving);
}

TEST(Drive, ALostLineStopsTheMotorsAndTheyComeBackWithIt) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_program("", "\"ahead\"")));
  robot.tick();
  robot.port.answers = false;
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
  robot.port.answers = true;
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

TEST(Drive, ALostCameraStopsTheMotorsOfAProgramThatUsesIt) {
  TestRobot seeing;
  ASSERT_TRUE(seeing.load(driving_program("input_devices: frame_grabber: end end", "\"ahead\"")));
  TestRobot blind;
  ASSERT_TRUE(blind.load(driving_program("", "\"ahead\"")));
  for (TestRobot* robot : {&seeing, &blind}) {
    robot->camera.answers = false;
    robot->tick();
  }
  EXPECT_FALSE(seeing.drive.moving);
  EXPECT_TRUE(blind.drive.moving);
  seeing.camera.answers = true;
  seeing.tick();
  EXPECT_TRUE(seeing.drive.moving);
}

TEST(Drive, WhenNobodyDrivesAnyMoreTheLastCommandEndsWithItsTimeout) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_program("", "\"ahead\"")));
  robot.tick();
  // The same state without a schema that drives: no transition says that the motors should stop.
  ASSERT_TRUE(robot.load(driving_program("", "\"note\"")));
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  robot.tick(6);
  EXPECT_TRUE(robot.drive.moving) << "0.35 s after the command";
  EXPECT_EQ(robot.drive.renewals, 7) << "the board stops motors of which it hears nothing";
  robot.tick();
  EXPECT_EQ(robot.drive.renewals, 7);
  EXPECT_FALSE(robot.drive.moving) << "0.4 s after the command";
}

}  // namespace
}  // namespace galilean::robot
