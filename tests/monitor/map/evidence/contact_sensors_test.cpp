// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/contact_sensors.h"

#include <gtest/gtest.h>

#include <cmath>

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
  const AttributeSpec beam{.name = "beam_index",
                           .type = AttributeType::kInteger,
                           .default_value = Value(0.0),
                           .bit_of = "bits_variable",
                           .role = Role::kGripperBeam};
  const AttributeSpec command{.name = "command",
                              .type = AttributeType::kChoice,
                              .default_value = Value(std::string("close")),
                              .choices = {"open", "close"},
                              .role = Role::kGripperCommand};
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

class ContactSensorsTest : public testing::Test {
 protected:
  ContactSensorsTest() {
    sensors.set_program(fetching(), gripping());
    beam_breaks();
    now += ContactSensors::kSettled;
  }
  void beam_breaks() {
    msg::Variables variables;
    variables.items.push_back(
        {.name = "gripper", .type = msg::Variable_Constants::BITS, .valid = true, .values = {1}});
    sensors.update(variables, now);
  }
  bool holds_in(const std::string& state) {
    msg::RobotState message;
    message.state = state;
    sensors.update(message);
    return sensors.is_holding(now);
  }

  ContactSensors sensors;
  Time now{1s};
};

TEST_F(ContactSensorsTest, WhatBreaksTheBeamIsHeldOrPushed) {
  EXPECT_TRUE(holds_in("push"));
  EXPECT_TRUE(holds_in("carry"));
}

msg::Variables bits(const std::string& name, std::uint32_t value) {
  msg::Variables variables;
  variables.items.push_back({.name = name,
                             .type = msg::Variable_Constants::BITS,
                             .valid = true,
                             .values = {static_cast<double>(value)}});
  return variables;
}

TEST_F(ContactSensorsTest, WhatIsNoNumberOfBitsBreaksNoBeam) {
  sensors = {};
  sensors.set_program(fetching(), gripping());
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0, 1e300, 4294967296.0}) {
    msg::Variables variables;
    variables.items.push_back({.name = "gripper",
                               .type = msg::Variable_Constants::BITS,
                               .valid = true,
                               .values = {value}});
    sensors.update(variables, now);
    now += 10s;
    EXPECT_FALSE(holds_in("push")) << value;
  }
}

// The names are of no schema that ships: what counts is the role.
TEST(ContactSensors, KnowsBumpersByTheirRole) {
  const AttributeSpec which{.name = "which",
                            .type = AttributeType::kInteger,
                            .default_value = Value(-1.0),
                            .bit_of = "bits_variable",
                            .role = Role::kBumper};
  const Catalog catalog{{{"bits", ComponentKind::kVariable, "", {own_name()}},
                         {"skin", ComponentKind::kPerceptualSchema, "", {bits_variable(), which}}}};
  msg::Program program;
  program.files.push_back({"skin.bhdl", R"(
variables: bits: name: "all" end bits: name: "shared" end end
perceptual_schemas:
  skin: name: "whole" bits_variable: "all" end
  skin: name: "tail" bits_variable: "shared" which: 4 end
end
state: name: "feel" perceptual_schemas: "whole" "tail" end end
)"});
  ContactSensors own;
  own.set_program(program, catalog);
  Time now{1s};
  const auto touches = [&](const msg::Variables& variables) {
    now += 1s;
    own.update(variables, now);
    return own.is_touching(now);
  };
  EXPECT_TRUE(touches(bits("all", 1U << 31)));
  EXPECT_FALSE(touches(bits("all", 0)));
  EXPECT_TRUE(touches(bits("shared", 1U << 4)));
  EXPECT_FALSE(touches(bits("shared", 1U << 3))) << "another's bit";
  EXPECT_FALSE(touches(bits("elsewhere", 1)));
}

// Nobody looks at the beam there, and the variable says for ever what it said before.
TEST_F(ContactSensorsTest, AnOpenedGripperThatNobodyLooksAtHoldsNothing) {
  EXPECT_FALSE(holds_in("drop"));
}

}  // namespace
}  // namespace galilean::monitor
