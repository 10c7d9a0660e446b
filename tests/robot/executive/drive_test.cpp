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

/// Drives ahead. It defines a schema that needs the camera, and lists it if `looks`.
std::string looking_program(const std::string& devices, bool looks) {
  return devices + R"(
variables: image: name: "red" end
perceptual_schemas: look: name: "look" red_variable: "red" end end
motor_schemas: ahead: name: "ahead" speed: 0.2 end end
states:
  state: name: "go" )" +
         (looks ? "perceptual_schemas: \"look\" end " : "") + R"(motor_schemas: "ahead" end end
end
)";
}
constexpr const char* kNamedCamera = "input_devices: frame_grabber: end end";

TEST(Drive, ALostCameraStopsTheMotorsOfAProgramWhoseSchemasUseItEvenIfItDoesNotNameIt) {
  for (const char* devices : {kNamedCamera, ""}) {
    TestRobot robot;
    ASSERT_TRUE(robot.load(looking_program(devices, true)));
    robot.tick();
    EXPECT_TRUE(robot.drive.moving) << devices;
    robot.camera.answers = false;
    robot.tick();
    EXPECT_FALSE(robot.drive.moving) << devices;
    robot.camera.answers = true;
    robot.tick();
    EXPECT_TRUE(robot.drive.moving) << devices;
  }
}

TEST(Drive, ALostCameraStopsNoProgramWhoseStatesDoNotUseIt) {
  for (const char* devices : {kNamedCamera, ""}) {
    TestRobot robot;
    ASSERT_TRUE(robot.load(looking_program(devices, false)));
    robot.camera.answers = false;
    robot.tick();
    EXPECT_TRUE(robot.drive.moving) << devices;
  }
}

/// Returns the lines in which the robot's catalog finds that a device is not named.
std::vector<int> lines_without_device(const std::string& devices) {
  const auto checked = bhdl::check({{"test.bhdl", devices + R"(
variables: shaft: name: "shaft" bits: name: "b" image: name: "red" force: name: "f" end
perceptual_schemas: bumper_scanner: name: "scan" bits_variable: "b" end
  look: name: "look" red_variable: "red" end end
motor_schemas: move_robot: name: "go" input_force: "f" shaft_variable: "shaft" end end
state: name: "go" perceptual_schemas: "scan" "look" end motor_schemas: "go" end end
)"}},
                                   test_components().catalog());
  EXPECT_TRUE(checked.program);
  std::vector<int> lines;
  for (const auto& each : checked.diagnostics)
    if (each.code == "device/unnamed") lines.push_back(each.line);
  return lines;
}

TEST(Drive, AProgramThatUsesDevicesWithoutNamingThemIsWarnedOf) {
  EXPECT_EQ(lines_without_device(""), (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(lines_without_device("input_devices: communication_port: end frame_grabber: end end"),
            (std::vector<int>{5}));
  EXPECT_EQ(lines_without_device("input_devices: comm_port: end frame_grabber: end end "
                                 "output_devices: motor_drive: end end"),
            std::vector<int>());
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
