// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/opened_devices.h"

#include <gmock/gmock.h>

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Returns why a robot with these devices refuses a program with such sections; empty if it runs
/// it.
std::string refusal(const OpenedDevices& opened, const std::string& devices) {
  const auto program = program_of(devices + "\nstate: name: \"only\" end\n");
  const auto accepted = opened.accept(program, test_components().catalog());
  return accepted ? std::string() : accepted.error().message;
}

const OpenedDevices kOpened{.serial = "/dev/ttyS0", .camera = "ring:/io"};

TEST(OpenedDevices, AProgramThatNamesThemOrNoneRuns) {
  EXPECT_EQ(refusal(kOpened, ""), "");
  EXPECT_EQ(refusal(kOpened, "output_devices: motor_drive: forward_velocity: 60 end end"), "");
  EXPECT_EQ(refusal(kOpened,
                    "input_devices: communication_port: device: \"/dev/ttyS0\" end "
                    "frame_grabber: device: \"ring:/io\" end end"),
            "");
  EXPECT_EQ(refusal({.serial = "./b", .camera = "a/../c"},
                    "input_devices: comm_port: device: \"b\" end "
                    "frame_grabber: device: \"c\" end end"),
            "")
      << "the same place in other words";
}

TEST(OpenedDevices, AProgramThatNamesOthersIsRefusedWithBothNames) {
  EXPECT_THAT(refusal(kOpened, "input_devices: comm_port: device: \"/dev/ttyS1\" end end"),
              AllOf(HasSubstr("comm_port"), HasSubstr("'/dev/ttyS1'"), HasSubstr("'/dev/ttyS0'"),
                    HasSubstr("restart")));
  EXPECT_THAT(refusal(kOpened, "input_devices: communication_port: device: \"x\" end end"),
              HasSubstr("'x'"));
  EXPECT_THAT(refusal(kOpened, "input_devices: comm_port: end end"), HasSubstr("'/dev/ttyUSB0'"))
      << "a section without 'device' names the default";
  EXPECT_THAT(refusal(kOpened,
                      "input_devices: comm_port: device: \"/dev/ttyS1\" baud: 9600 end "
                      "frame_grabber: device: \"red.jpg\" end end"),
              AllOf(HasSubstr("'/dev/ttyS1'"), HasSubstr("9600 baud"), HasSubstr("115200 baud"),
                    HasSubstr("'red.jpg'"), HasSubstr("'ring:/io'")));
}

TEST(OpenedDevices, WhatTheCommandLineNamesProgramsDoNot) {
  EXPECT_EQ(refusal({},
                    "input_devices: comm_port: device: \"/dev/ttyS1\" end "
                    "frame_grabber: device: \"red.jpg\" end end"),
            "");
}

TEST(OpenedDevices, WhatAProgramNamesInVainIsSaid) {
  const auto& catalog = test_components().catalog();
  const auto overruled = [&](const OpenedDevices& opened, const std::string& devices) {
    return opened.overruled(program_of(devices + "\nstate: name: \"only\" end\n"), catalog);
  };
  const std::string names_both =
      "input_devices: comm_port: device: \"/dev/ttyS1\" end "
      "frame_grabber: device: \"red.jpg\" end end";
  EXPECT_EQ(overruled({}, names_both),
            "comm_port is '/dev/ttyS1', and frame_grabber is 'red.jpg' in test.bhdl, which does "
            "not count: the command line named another");
  EXPECT_EQ(overruled({.serial = "/dev/ttyS1"}, names_both),
            "frame_grabber is 'red.jpg' in test.bhdl, which does not count: the command line named "
            "another");
  EXPECT_EQ(overruled(kOpened, names_both), "");
  EXPECT_EQ(overruled({}, "input_devices: comm_port: baud: 9600 end end"), "");
  EXPECT_EQ(overruled({}, ""), "");
}

TEST(OpenedDevices, AProgramThatNamesNoneIsOpenedWithThoseOfTheGivenOne) {
  const auto& catalog = test_components().catalog();
  const auto settings = [&](const std::string& devices) {
    return DeviceSettings::of(program_of(devices + "\nstate: name: \"only\" end\n"), catalog);
  };
  const DeviceSettings given = settings(
      "input_devices: comm_port: device: \"/dev/ttyS1\" baud: 9600 timeout: 2 end "
      "frame_grabber: device: \"red.jpg\" end end");
  const auto opened = [&](const std::string& devices) {
    return settings_to_open(program_of(devices + "\nstate: name: \"pushed\" end\n"), given,
                            catalog);
  };
  const DeviceSettings none = opened("");
  EXPECT_EQ(none.comm_port.device, "/dev/ttyS1");
  EXPECT_EQ(none.comm_port.baud, 9600);
  EXPECT_EQ(none.comm_port.timeout_s, settings("").comm_port.timeout_s) << "it is its own";
  EXPECT_EQ(none.frame_grabber.device, "red.jpg");
  const DeviceSettings own = opened(
      "input_devices: comm_port: device: \"/dev/ttyS2\" end "
      "frame_grabber: device: \"blue.jpg\" end end");
  EXPECT_EQ(own.comm_port.device, "/dev/ttyS2");
  EXPECT_EQ(own.comm_port.baud, 115200);
  EXPECT_EQ(own.frame_grabber.device, "blue.jpg");
}

TEST(OpenedDevices, TheExecutiveGoesOnWithTheProgramThatItHas) {
  TestRobot robot;
  ASSERT_TRUE(robot.load("state: name: \"first\" end\n"));
  robot.tick();
  robot.admits = [](const bhdl::Program&) { return Result<void>(Error{"no such camera"}); };
  const auto loaded = robot.load("state: name: \"second\" end\n");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().message, "no such camera");
  robot.tick();
  EXPECT_EQ(robot.state(), "first");
  EXPECT_FALSE(robot.executive->waiting());
}

}  // namespace
}  // namespace galilean::robot
