// SPDX-License-Identifier: BSD-3-Clause
// A schema of one's own is a class and a line in the list: everybody else knows it by its roles.
#include "tests/robot/own_schemas.h"

#include <gmock/gmock.h>

#include "bhdl/check/describe.h"
#include "sim/headless/headless.h"
#include "tests/bhdl/lsp/editor.h"
#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

const Registry& own_components() {
  static const Registry registry = [] {
    Registry made;
    add_components(made);
    add_own_schemas(made);
    return made;
  }();
  return registry;
}

constexpr const char* kOwnProgram = R"(
variables:
  shaft: name: "shaft"
  image: name: "lines"
  locate: name: "lamp" class: "trash"
  bits: name: "near"
  force: name: "left"  force: name: "right"  force: name: "slow"  force: name: "way"
end
perceptual_schemas:
  contours: name: "draw" drawn_on: "lines" end
  glow: name: "find" scene: "lines" found: "lamp" glow: 70 end
  in_reach: name: "reach" target: "lamp" odometer: "shaft" flags: "near" end
end
motor_schemas:
  noise: name: "to_left" shaft_variable: "shaft" result: "left" end
  noise: name: "to_right" shaft_variable: "shaft" result: "right" end
  noise: name: "to_slow" shaft_variable: "shaft" result: "slow" end
  steer: name: "steer" pulls: "left" "right" weights: 2 0.25 brake: "slow" grip: 3 way: "way" end
end
states:
  state: name: "wait" perceptual_schemas: "draw" "find" "reach" end
    condition: bits_variable: "near" bit_index: 3 bit_value: 1 new_state: "go" end end
  state: name: "go" perceptual_schemas: "draw" "find" "reach" end
    motor_schemas: "to_left" "to_right" "to_slow" "steer" end end
end
)";

TEST(OwnSchema, IsDescribed) {
  const auto words = bhdl::describe(own_components().catalog(), "in_reach");
  ASSERT_TRUE(words);
  EXPECT_THAT(words.value(), HasSubstr("Tells what the arm could reach."));
  EXPECT_THAT(words.value(), HasSubstr("how long the arm is"));
}

TEST(OwnSchema, IsCompletedInAnEditor) {
  bhdl::lsp::Editor editor({}, {}, own_components().catalog());
  editor.open("a.bhdl", "perceptual_schemas:\n  in|\nend");
  EXPECT_THAT(editor.completions(), Contains("in_reach"));
  editor.open("b.bhdl", "motor_schemas:\n  steer: name: \"s\" |\n  end\nend");
  EXPECT_THAT(editor.completions(), IsSupersetOf({"pulls", "weights", "brake", "grip", "way"}));
}

TEST(OwnSchema, TellsItsGainsBesideTheForces) {
  TelemetryRobot io("own_gains", own_components());
  auto forces = io.mailbox<msg::Forces>("forces");
  ASSERT_TRUE(io.robot.load(kOwnProgram));
  ASSERT_TRUE(io.tick_until([&] { return !forces.all().empty(); }));
  const msg::Forces first = forces.all().front();
  std::map<std::string, float> gains;
  for (const auto& force : first.items) gains[force.variable] = force.gain;
  EXPECT_THAT(gains, ElementsAre(std::pair("left", 2.0F), std::pair("right", 0.25F),
                                 std::pair("slow", 3.0F), std::pair("way", 1.0F)));
}

TEST(OwnSchema, ShowsItsPictureOnATopicOfItsOwn) {
  TelemetryRobot io("own_picture", own_components());
  auto pictures = io.mailbox<msg::CompressedImage>("contours/compressed");
  ASSERT_TRUE(io.robot.load(kOwnProgram));
  ASSERT_TRUE(io.tick_until([&] {
    ++io.robot.camera.picture.number;
    return !pictures.all().empty();
  }));
  EXPECT_EQ(pictures.all().front().format, "png");
}

TEST(OwnSchema, ItsBitFiresACondition) {
  TestRobot robot(1, {}, {}, own_components());
  ASSERT_TRUE(robot.load(kOwnProgram));
  robot.tick(3);
  EXPECT_EQ(robot.state(), "go") << "the lamp lies where the robot is";
}

/// How long a robot of the simulator counts as stuck that does not move in a state.
double stuck_s(const std::string& motor_schemas) {
  const std::string program = std::string(kOwnProgram) +
                              "start_state: \"stand\"\nstate: name: \"stand\" " +
                              "motor_schemas: " + motor_schemas + " end end\n";
  auto checked = bhdl::check({{"own.bhdl", program}}, own_components().catalog());
  if (!checked.program) ADD_FAILURE() << format(checked.diagnostics.at(0));
  auto contest =
      sim::HeadlessContest::make(sim::load_scenario("empty").value(), own_components(),
                                 checked.program.value(), {.robots = 1, .duration_s = 3});
  EXPECT_TRUE(contest && contest.value()->run());
  return contest.value()->robot(0).statistics().stuck.stuck_s();
}

TEST(OwnSchema, DrivesInTheSimulator) {
  EXPECT_NEAR(stuck_s("\"steer\""), 3, 0.1) << "it tries to move and does not";
  EXPECT_EQ(stuck_s("\"to_left\""), 0) << "nothing drives";
}

}  // namespace
}  // namespace galilean::robot
