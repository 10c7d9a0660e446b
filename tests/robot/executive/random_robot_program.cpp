// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/executive/random_robot_program.h"

#include <algorithm>

namespace galilean::robot {
namespace {

std::string quoted(const std::string& name) {
  return "\"" + name + "\" ";
}

const std::vector<std::string>& state_names() {
  static const std::vector<std::string> names{"a", "b", "c", "d", "e"};
  return names;
}

}  // namespace

std::string RandomRobotProgram::draw(std::string_view mark) {
  for (Names* names : {&locates_, &bits_, &forces_, &images_, &perceptual_, &motor_, &states_})
    names->clear();
  text_ = chance(2) ? "input_devices: frame_grabber: end end\n" : "";
  text_ += "output_devices: motor_drive: timeout: 0." + std::to_string(1 + below(9)) + " end end\n";
  draw_variables();
  draw_perceptual_schemas(mark);
  draw_motor_schemas(mark);
  draw_states();
  draw_on_swap();
  return text_;
}

void RandomRobotProgram::draw_variables() {
  text_ += "variables:\n  shaft: name: \"shaft\" status: \"valid\"\n";
  if (chance(3)) add_variable("image", "red"), images_.push_back("red");
  for (const char* name : {"trash", "basket", "other"})
    if (!chance(3)) add_variable("locate", name), locates_.push_back(name);
  for (const char* name : {"bumpers", "gripper", "seen"})
    if (!chance(3)) add_variable("bits", name), bits_.push_back(name);
  for (const char* name : {"away", "towards", "sum"})
    if (!chance(3)) add_variable("force", name), forces_.push_back(name);
  // Only the names of these are the same in every program. Their types differ.
  for (const char* name : {"x0", "x1", "x2"}) {
    static const Names kTypes{"locate", "bits", "force"};
    const std::string& type = one_of(kTypes);
    add_variable(type, name);
    (type == "locate" ? locates_ : type == "bits" ? bits_ : forces_).push_back(name);
  }
  // Every program has one of each type.
  add_variable("locate", "l"), locates_.push_back("l");
  add_variable("bits", "b"), bits_.push_back("b");
  add_variable("force", "f"), forces_.push_back("f");
  text_ += "end\n";
}

void RandomRobotProgram::add_variable(const std::string& type, const std::string& name) {
  text_ += "  " + type + ": name: " + quoted(name) + "memory: " + std::to_string(below(4) * 20);
  if (chance(3)) text_ += " status: \"valid\" certainty: 0." + std::to_string(1 + below(9));
  if (type == "force" && chance(2)) text_ += " value: <0, " + std::to_string(below(3)) + ">";
  if (type == "bits" && chance(2)) text_ += " value: " + std::to_string(below(256));
  text_ += "\n";
}

void RandomRobotProgram::add_schema(Names& kind, const std::string& type, const std::string& name,
                                    const std::string& attributes) {
  text_ += "  " + type + ": name: " + quoted(name) + attributes + "end\n";
  kind.push_back(name);
}

void RandomRobotProgram::draw_perceptual_schemas(std::string_view mark) {
  const auto bit = [this](const std::string& attribute) {
    return attribute + ": " + std::to_string(below(8)) + " ";
  };
  const std::string word = "word: " + quoted("perceive " + std::string(mark));
  text_ += "perceptual_schemas:\n  note: name: \"first\" " + word + "end\n  note: name: \"last\" " +
           word + "end\n";
  add_schema(perceptual_, "bumper_scanner", "bumps", given("bits_variable", bits_));
  add_schema(perceptual_, "gripper_scanner", "grips", given("bits_variable", bits_));
  add_schema(perceptual_, "count_bits", "counts", given("bits_variable", bits_));
  add_schema(
      perceptual_, "obstacle_detector", "touches",
      given("bits_variable", bits_) + bit("bit_index") + given("obstacle_variable", locates_));
  add_schema(perceptual_, "seen", "sees",
             given("locate_variable", locates_) + given("bits_variable", bits_) + bit("bit_index"));
  add_schema(perceptual_, "lost", "loses",
             given("locate_variable", locates_) + given("bits_variable", bits_) + bit("bit_index"));
  add_schema(perceptual_, "time_detector", "waits",
             given("bits_variable", bits_) + bit("bit_index") + "duration: 0." +
                 std::to_string(1 + below(9)) + " ");
  add_schema(perceptual_, "forget", "forgets",
             given("variables", locates_) + "time: " + std::to_string(below(30)) + " ");
  if (!images_.empty()) add_schema(perceptual_, "look", "looks", given("red_variable", images_));
  if (chance(6))
    add_schema(perceptual_, "thrower", "throws",
               "after: " + std::to_string(below(20)) + " " + given("bits_variable", bits_));
  text_ += "end\n";
}

void RandomRobotProgram::draw_motor_schemas(std::string_view mark) {
  const std::string word = "word: " + quoted("act " + std::string(mark));
  text_ += "motor_schemas:\n  note_motor: name: \"first\" " + word +
           "end\n  note_motor: name: \"last\" " + word + "end\n";
  draw_forces();
  add_schema(motor_, "move_robot", "moves",
             given("input_force", forces_) + "shaft_variable: \"shaft\" ");
  add_schema(motor_, "move_gripper", "grips", given("bits_variable", bits_));
  if (chance(3)) add_schema(motor_, "ahead", "runs", "");
  text_ += "end\n";
}

void RandomRobotProgram::draw_forces() {
  const std::string shaft = "shaft_variable: \"shaft\" ";
  const auto result = [this] { return given("result", forces_); };
  add_schema(motor_, "noise", "wanders", shaft + result());
  add_schema(motor_, "avoid_obstacle", "avoids",
             shaft + given("obstacle_variable", locates_) + result());
  add_schema(motor_, "swirl", "swirls", shaft + given("obstacle_variable", locates_) + result());
  add_schema(motor_, "move_to_goal", "goes", shaft + given("goal_variable", locates_) + result());
  add_schema(motor_, "guarded_goal", "nears", shaft + given("goal_variable", locates_) + result());
  add_schema(motor_, "dock", "docks", shaft + given("dock_variable", locates_) + result());
  add_schema(motor_, "combine_forces", "adds", "inputs: " + some_of(forces_) + result());
}

void RandomRobotProgram::draw_states() {
  for (const std::string& name : state_names())
    if (chance(2)) states_.push_back(name);
  if (states_.empty()) states_.push_back("only");
  for (const std::string& name : states_) draw_state(name);
}

void RandomRobotProgram::draw_state(const std::string& name) {
  text_ += "state: name: " + quoted(name) + "\n  perceptual_schemas: \"first\" ";
  text_ += some_of(perceptual_) + "\"last\" end\n  motor_schemas: \"first\" ";
  text_ += some_of(motor_) + "\"last\" end\n";
  for (std::uint32_t i = below(4); i > 0; --i) draw_condition();
  text_ += "end\n";
}

void RandomRobotProgram::draw_condition() {
  static const Names kUpdates{"same", "set", "clear", "toggle"};
  text_ += "  condition: " + given("bits_variable", bits_) +
           "bit_index: " + std::to_string(below(8)) + " bit_value: " + std::to_string(below(2)) +
           " bit_update: " + quoted(one_of(kUpdates));
  if (chance(3)) text_ += given("reset_variables", chance(2) ? locates_ : forces_);
  text_ += given("new_state", states_) + "end\n";
}

void RandomRobotProgram::draw_on_swap() {
  std::string lines;
  for (const std::string& name : state_names())
    if (std::ranges::find(states_, name) == states_.end() && chance(2))
      lines += "\"" + name + "\": " + quoted(one_of(states_));
  if (!lines.empty()) text_ += "on_swap: " + lines + "end\n";
}

const std::string& RandomRobotProgram::one_of(const Names& names) {
  return names[below(static_cast<std::uint32_t>(names.size()))];
}

std::string RandomRobotProgram::given(const std::string& attribute, const Names& names) {
  return attribute + ": " + quoted(one_of(names));
}

std::string RandomRobotProgram::some_of(const Names& names) {
  std::string chosen;
  for (const std::string& name : names)
    if (chance(2)) chosen += quoted(name);
  return chosen.empty() ? quoted(names.front()) : chosen;
}

}  // namespace galilean::robot
