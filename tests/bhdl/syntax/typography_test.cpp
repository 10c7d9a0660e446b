// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

// Every way in which the published listings depart from plain text, in a program of our own.
TEST(Typography, OfThePublishedListingsLoads) {
  const auto result = check_text(
      "; \n;  What the robot is made of.\n;\n\n"
      "input_devices:\ncomm_port:\n\ntimeout: 5\nend:\n\nframe_grabber:\nend:\n\n"
      ";\n; output_devices:\n\n"
      "motor_drive:\nturn_radius: 20.5 ; in cms.\nstright_dead_zones: 20 20 –20 –20 ; power\n"
      "end:\n\nend: \n\n"
      "variables:\n\n; Sensors.\n\n"
      "shaft: \nname: “pose” position: (0,0) heading: 0 status: “valid” certainty: 1\n\n"
      "bits: \nname: “touch” value: 0 status: “invalid”\n\n"
      "locate:\nname: “wall” status: “invalid”\n\n"
      "force:\nname: “rear” value: <0,–1> status: “valid” \n\n"
      "percp_schemas:\nbumper_scanner: name: “scan” bits_variable: “touch” "
      "end;\nobstacle_detector:\n\nname: “front”\nbits_variable: “touch” \nbit_index: 2\n"
      "translation: <0.0,21.0> \nobstacle_variable: “wall”\nshaft_variable: “pose”\nend;\n\n"
      "motor_schemas:\nmove_robot: \n\nname: “go”\ninput_force: “rear”\n"
      "max_distance_magnitude: 12.0 ; in cms.\nend:\n\n"
      "state:\nname: “reverse”\nperceptual_schemas: ; what it senses.\n\n“scan” “front”\nend:\n\n"
      "motor_schemas: ; what it does.\n“go”\nend:\n\n"
      "condition: ; on a touch.\nbits_variable: “touch”\nbit_index: 2\nbit_value: 1\n"
      "bit_update: “same”\nnew_state: “reverse”\nreset_variables: “wall”\n\nend:\nend: \n");
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(summary(result),
            "17:1 warning name/wrong-section\n"
            "19:1 warning name/misspelt-attribute\n");
  EXPECT_EQ(result.program->devices.size(), 3u);
  EXPECT_EQ(result.program->variables.back().attributes.get<Vec2>("value"), Vec2(0, -1));
  EXPECT_DOUBLE_EQ(result.program->perceptual_schemas[1].attributes.get<Vec2>("translation").y(),
                   0.21);
}

TEST(Typography, OfOtherEditorsLoadsTheSame) {
  const std::string unix_text =
      "variables:\n  bits: name: \"b\"\nend\n; a comment\nstate:\n  name: \"s\"\nend\n";
  std::string dos_text;
  for (char c : unix_text) dos_text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string mac_text = unix_text;
  for (char& c : mac_text) c = c == '\n' ? '\r' : c;
  std::string unfinished_text = unix_text.substr(0, unix_text.size() - 1);
  for (const auto& text : {unix_text, dos_text, mac_text, unfinished_text, "\uFEFF" + unix_text}) {
    const auto result = check_text(text);
    ASSERT_TRUE(result.program) << printed(result);
    EXPECT_EQ(result.program->states[0].location.line, 5);
    EXPECT_EQ(result.program->states[0].location.column, 1);
  }
}

}  // namespace
}  // namespace galilean::bhdl
