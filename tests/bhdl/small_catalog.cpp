// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

AttributeSpec number(std::string name, Unit unit, double default_value, double minimum,
                     double maximum) {
  return {.name = std::move(name),
          .type = AttributeType::kNumber,
          .unit = unit,
          .default_value = Value(default_value),
          .minimum = minimum,
          .maximum = maximum,
          .help = "a number"};
}

AttributeSpec reference(std::string name, std::string type, Access access) {
  return {.name = std::move(name),
          .type = AttributeType::kName,
          .refers_to = std::move(type),
          .access = access,
          .help = "a variable"};
}

AttributeSpec status() {
  return {.name = "status",
          .type = AttributeType::kChoice,
          .default_value = Value(std::string("invalid")),
          .choices = {"valid", "invalid"},
          .help = "whether the content may be used"};
}

AttributeSpec pair(std::string name, Unit unit) {
  return {.name = std::move(name),
          .type = AttributeType::kPair,
          .unit = unit,
          .default_value = Value(Vec2(0, 0)),
          .minimum = -500,
          .maximum = 500,
          .help = "a pair"};
}

ComponentSpec motor_drive() {
  AttributeSpec dead_zones{.name = "straight_dead_zones",
                           .aliases = {"stright_dead_zones"},
                           .type = AttributeType::kNumbers,
                           .unit = unit::kPwm,
                           .default_value = Value(std::vector<double>{0, 0, 0, 0}),
                           .minimum = -1000,
                           .maximum = 1000,
                           .count = 4,
                           .help = "power at which the treads begin to move"};
  return {"motor_drive",
          ComponentKind::kOutputDevice,
          "Drives.",
          {std::move(dead_zones), number("turn_radius", unit::kCentimetre, 18.5, 1, 100),
           number("timeout", unit::kSecond, 0.5, 0, 60)}};
}

ComponentSpec combine_forces() {
  AttributeSpec inputs{.name = "forces",
                       .type = AttributeType::kNames,
                       .refers_to = "force",
                       .access = Access::kRead,
                       .help = "what is combined"};
  AttributeSpec gains{.name = "gains",
                      .type = AttributeType::kNumbers,
                      .default_value = Value(std::vector<double>{}),
                      .one_for_each = "forces",
                      .role = Role::kGain,
                      .of = "forces",
                      .help = "the weight of each"};
  return {"combine_forces",
          ComponentKind::kMotorSchema,
          "Adds forces.",
          {std::move(inputs), std::move(gains), reference("result", "force", Access::kWrite)}};
}

ComponentSpec noise() {
  AttributeSpec steps{.name = "steps",
                      .type = AttributeType::kInteger,
                      .default_value = Value(3.0),
                      .minimum = 1,
                      .help = "a whole number"};
  AttributeSpec fresh{.name = "fresh",
                      .type = AttributeType::kFlag,
                      .default_value = Value(true),
                      .help = "yes or no"};
  return {"noise",
          ComponentKind::kMotorSchema,
          "A random heading.",
          {number("persistence", unit::kSecond, 5, 0, 600), std::move(steps), std::move(fresh),
           reference("result", "force", Access::kWrite),
           number(kGainAttribute, unit::kNone, 1, 0, 1e6)}};
}

ComponentSpec forget() {
  AttributeSpec variables{.name = "variables",
                          .type = AttributeType::kNames,
                          .refers_to = "variable",
                          .help = "what fades"};
  AttributeSpec shaft = reference("shaft_variable", "shaft", Access::kRead);
  shaft.default_value = Value(std::string());
  AttributeSpec radius = number("radius", unit::kCentimetre, 50, 0, 1000);
  radius.only_with = "shaft_variable";
  AttributeSpec always = number("delay", unit::kSecond, 0, 0, 100);
  always.only_without = "shaft_variable";
  return {"forget",
          ComponentKind::kPerceptualSchema,
          "Fades variables.",
          {std::move(variables), number("time", unit::kSecond, 60, 0, 1e4), std::move(shaft),
           std::move(radius), std::move(always)}};
}

ComponentSpec time_detector() {
  return {"time_detector",
          ComponentKind::kPerceptualSchema,
          "Sets a bit after a time.",
          {reference("bits_variable", "bits", Access::kUpdate),
           {.name = "bit_index",
            .type = AttributeType::kInteger,
            .default_value = Value(0.0),
            .minimum = 0,
            .maximum = 31,
            .bit_of = "bits_variable",
            .help = "which bit"},
           number("duration", unit::kSecond, 1, 0, 600)}};
}

ComponentSpec obstacle_detector() {
  AttributeSpec shaft = reference("shaft_variable", "shaft", Access::kRead);
  shaft.default_value = Value(std::string("shaft"));
  return {"obstacle_detector",
          ComponentKind::kPerceptualSchema,
          "Remembers what was touched.",
          {reference("bits_variable", "bits", Access::kRead),
           {.name = "bit_index",
            .type = AttributeType::kInteger,
            .default_value = Value(0.0),
            .minimum = 0,
            .maximum = 31,
            .help = "which bumper"},
           pair("translation", unit::kCentimetre),
           reference("obstacle_variable", "locate", Access::kWrite),
           std::move(shaft)}};
}

ComponentSpec look() {
  ComponentSpec spec{"look",
                     ComponentKind::kPerceptualSchema,
                     "Finds an object in the camera's picture.",
                     {reference("locate_variable", "locate", Access::kWrite)}};
  spec.needs = {"frame_grabber"};
  return spec;
}

}  // namespace

Catalog small_catalog() {
  using enum ComponentKind;
  AttributeSpec device{.name = "device",
                       .type = AttributeType::kText,
                       .default_value = Value(std::string("/dev/ttyS0")),
                       .help = "the serial line"};
  return {{{"comm_port",
            kInputDevice,
            "The serial line.",
            {std::move(device), number("timeout", unit::kSecond, 0.5, 0, 60)}},
           {"frame_grabber",
            kInputDevice,
            "The camera.",
            {number("view_angle", unit::kDegree, 73.5, 1, 179)}},
           motor_drive(),
           {"shaft",
            kVariable,
            "Where the robot is.",
            {pair("position", unit::kCentimetre), number("heading", unit::kDegree, 0, -360, 360),
             status(), number("certainty", unit::kNone, 1, 0, 1)}},
           {"bits",
            kVariable,
            "Binary events.",
            {number("value", unit::kNone, 0, 0, 4294967295.0), status()}},
           {"locate",
            kVariable,
            "Where an object is.",
            {pair("position", unit::kCentimetre), status()}},
           {"force",
            kVariable,
            "What a motor schema suggests.",
            {pair("value", unit::kNone), status()}},
           {"bumper_scanner",
            kPerceptualSchema,
            "Reads the bumpers.",
            {reference("bits_variable", "bits", Access::kWrite)}},
           look(),
           obstacle_detector(),
           time_detector(),
           forget(),
           noise(),
           {"move_robot",
            kMotorSchema,
            "Drives along a force.",
            {reference("input_force", "force", Access::kRead),
             number("max_distance_magnitude", unit::kCentimetre, 15, 0, 100),
             number("safety_range", unit::kDegree, 30, 0, 180),
             number(kGainAttribute, unit::kNone, 1, 0, 1e6)},
            "motor_drive"},
           combine_forces()}};
}

CheckResult check_text(std::string text) {
  return check({{"program.bhdl", std::move(text)}}, small_catalog());
}

std::string program_with_states(const std::string& states) {
  return "variables:\n"
         "  shaft: name: \"shaft\"\n"
         "  bits: name: \"bumpers\"\n"
         "  force: name: \"ahead\"\n"
         "end\n"
         "perceptual_schemas: bumper_scanner: name: \"scan\" bits_variable: \"bumpers\" end end\n"
         "motor_schemas:\n"
         "  noise: name: \"wander\" result: \"ahead\" end\n"
         "  move_robot: name: \"drive\" input_force: \"ahead\" end\n"
         "end\n" +
         states;
}

std::string summary(const CheckResult& result) {
  std::string text;
  for (const auto& each : result.diagnostics)
    text += std::to_string(each.line) + ':' + std::to_string(each.column) + ' ' +
            std::string(to_string(each.severity)) + ' ' + each.code + '\n';
  return text;
}

std::string printed(const CheckResult& result) {
  std::string text;
  for (const auto& each : result.diagnostics) text += format(each) + '\n';
  return text;
}

}  // namespace galilean::bhdl
