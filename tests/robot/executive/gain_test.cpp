// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

/// A force of length 1 times `gain`, onto a variable that another schema writes before.
std::string noisy_program(const std::string& gain) {
  return R"(
variables:
  shaft: name: "shaft"
  force: name: "a"
end
perceptual_schemas: write_all: name: "before" force_variable: "a" end end
motor_schemas: noise: name: "noise" shaft_variable: "shaft" result: "a" )" +
         gain + R"( end end
state: name: "only" perceptual_schemas: "before" end motor_schemas: "noise" end end
)";
}

double force_after_ticks(const std::string& gain) {
  TestRobot robot;
  EXPECT_TRUE(robot.load(noisy_program(gain)));
  robot.tick(5);
  return robot.variable<Force>("a").value.value.norm();
}

TEST(Gain, MultipliesTheForceThatAMotorSchemaWritesInEachTickOnce) {
  EXPECT_DOUBLE_EQ(force_after_ticks(""), 1);
  EXPECT_DOUBLE_EQ(force_after_ticks("gain: 2.5"), 2.5);
  EXPECT_DOUBLE_EQ(force_after_ticks("gain: 0"), 0);
}

TEST(Gain, LeavesAForceAloneThatItsSchemaDidNotWrite) {
  TestRobot robot;
  robot.port.answers = false;
  ASSERT_TRUE(robot.load(noisy_program("gain: 3")));
  robot.tick(5);
  EXPECT_DOUBLE_EQ(robot.variable<Force>("a").value.value.norm(), 5) << "the number of the tick";
  EXPECT_EQ(robot.variable<Force>("a").written_tick, 5U);
}

TEST(Gain, EveryMotorSchemaTakesOneAndNoOtherComponentDoes) {
  for (const auto& component : test_components().catalog().components)
    EXPECT_EQ(component.find(kGainAttribute) != nullptr,
              component.kind == ComponentKind::kMotorSchema)
        << component.name;
}

}  // namespace
}  // namespace galilean::robot
