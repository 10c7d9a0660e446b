#include "monitor/map/evidence/senses.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

AttributeSpec bits_variable() {
  return {.name = "bits_variable",
          .type = AttributeType::kName,
          .refers_to = "bits",
          .access = Access::kUpdate};
}

AttributeSpec own_name() {
  return {.name = "name", .type = AttributeType::kName};
}

Catalog gripping() {
  const AttributeSpec beam{
      .name = "beam_index", .type = AttributeType::kInteger, .default_value = Value(0.0)};
  const AttributeSpec command{.name = "command",
                              .type = AttributeType::kChoice,
                              .default_value = Value(std::string("close")),
                              .choices = {"open", "close"}};
  return {{{"bits", ComponentKind::kVariable, "", {own_name()}},
           {"gripper_scanner", ComponentKind::kPerceptualSchema, "", {bits_variable(), beam}},
           {"move_gripper", ComponentKind::kMotorSchema, "", {command}}}};
}

msg::Program fetching() {
  msg::Program program;
  program.files.push_back({"fetch.bhdl", R"(
variables: bits: name: "gripper" end
perceptual_schemas: gripper_scanner: name: "scan" bits_variable: "gripper" end end
motor_schemas:
  move_gripper: name: "open" command: "open" end
  move_gripper: name: "close" end
end
state: name: "push"  perceptual_schemas: "scan" end  motor_schemas: "open" end end
state: name: "carry" motor_schemas: "close" end end
state: name: "drop"  motor_schemas: "open" end end
)"});
  return program;
}

class SensesTest : public testing::Test {
 protected:
  SensesTest() {
    senses.note(fetching(), gripping());
    beam_breaks();
    now += Senses::kSettled;
  }
  void beam_breaks() {
    msg::Variables variables;
    variables.items.push_back(
        {.name = "gripper", .type = msg::Variable_Constants::BITS, .valid = true, .values = {1}});
    senses.note(variables, now);
  }
  bool holds_in(const std::string& state) {
    msg::RobotState message;
    message.state = state;
    senses.note(message);
    return senses.holds(now);
  }

  Senses senses;
  Time now{1s};
};

TEST_F(SensesTest, WhatBreaksTheBeamIsHeldOrPushed) {
  EXPECT_TRUE(holds_in("push"));
  EXPECT_TRUE(holds_in("carry"));
}

// Nobody looks at the beam there, and the variable says for ever what it said before.
TEST_F(SensesTest, AnOpenedGripperThatNobodyLooksAtHoldsNothing) {
  EXPECT_FALSE(holds_in("drop"));
}

}  // namespace
}  // namespace galilean::monitor
