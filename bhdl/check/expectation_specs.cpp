// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/expectation_specs.h"

#include <array>

#include "bhdl/check/state_specs.h"
#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean::bhdl {
namespace {

AttributeSpec seconds(std::string name, std::optional<Value> default_value, std::string help) {
  return {.name = std::move(name),
          .type = AttributeType::kNumber,
          .unit = unit::kSecond,
          .default_value = std::move(default_value),
          .minimum = 0,
          .maximum = kLongestExpectation_s,
          .help = std::move(help)};
}

AttributeSpec optional_name(std::string name, std::string refers_to, std::string help) {
  return {.name = std::move(name),
          .type = AttributeType::kName,
          .default_value = Value(std::string()),
          .refers_to = std::move(refers_to),
          .help = std::move(help)};
}

AttributeSpec expected_state() {
  return {.name = "state",
          .type = AttributeType::kName,
          .refers_to = "state",
          .help = "the state that it is about"};
}

ComponentSpec make_expect() {
  return {
      .name = "expect",
      .help =
          "A test of the program's behaviour, without a robot. It says what is given and which "
          "states must follow. Robots ignore it.",
      .attributes = {
          name_spec(),
          optional_name("from_state", "state", "where it begins; else in the start state"),
          seconds("lasts", Value(0.0), "how long it runs; 0: to the last time that a step names")}};
}

AttributeSpec of_condition(std::string_view attribute, std::string help) {
  AttributeSpec spec = *condition_spec().find(attribute);
  spec.help = std::move(help);
  return spec;
}

AttributeSpec of_variable(AttributeSpec spec, std::string variable) {
  spec.only_with = std::move(variable);
  return spec;
}

AttributeSpec pair(std::string name, Unit unit, std::string help) {
  return {.name = std::move(name),
          .type = AttributeType::kPair,
          .unit = unit,
          .default_value = Value(Vec2(0, 0)),
          .help = std::move(help)};
}

AttributeSpec heading() {
  return {.name = "heading",
          .type = AttributeType::kNumber,
          .unit = unit::kDegree,
          .default_value = Value(0.0),
          .minimum = -360,
          .maximum = 360,
          .help = "which way the robot faces, counter-clockwise from the frame's x axis"};
}

AttributeSpec position() {
  AttributeSpec spec =
      pair("position", unit::kCentimetre, "of the place or of the robot, in its global frame");
  spec.only_without = "force_variable";
  return spec;
}

ComponentSpec make_given() {
  return {
      .name = "given",
      .help = "Gives a variable a fixed value for a time. Values that schemas write are replaced.",
      .attributes = {
          optional_name("bits_variable", variable_type_name<Bits>(),
                        "the variable, if it holds bits"),
          of_variable(of_condition("bit_index", "which of its bits"), "bits_variable"),
          of_variable(of_condition("bit_value", "what the bit is"), "bits_variable"),
          optional_name("locate_variable", variable_type_name<Locate>(),
                        "the variable, if it is a place"),
          optional_name("shaft_variable", variable_type_name<Shaft>(),
                        "the variable, if it is where the robot is"),
          position(),
          of_variable(heading(), "shaft_variable"),
          optional_name("force_variable", variable_type_name<Force>(),
                        "the variable, if it is a force"),
          of_variable(pair("value", unit::kNone, "of the force: right, forward"), "force_variable"),
          {.name = "status",
           .type = AttributeType::kChoice,
           .default_value = Value(std::string("valid")),
           .choices = {"valid", "invalid"},
           .help = "whether the variable is known"},
          seconds("from", Value(0.0), "from when on"),
          seconds("until", Value(kLongestExpectation_s), "and until when")}};
}

ComponentSpec make_claim(std::string name, std::string help, std::optional<Value> from,
                         AttributeSpec until) {
  return {.name = std::move(name),
          .help = std::move(help),
          .attributes = {expected_state(), seconds("from", std::move(from), "from when on"),
                         std::move(until)}};
}

}  // namespace

const ComponentSpec& expect_spec() {
  static const ComponentSpec spec = make_expect();
  return spec;
}

const ComponentSpec& given_spec() {
  return step_specs().front();
}

std::span<const ComponentSpec> step_specs() {
  static const std::array<ComponentSpec, 4> specs{
      make_given(),
      make_claim("reaches", "The state is entered in time.", Value(0.0),
                 seconds("by", std::nullopt, "until when it must have been current")),
      make_claim("stays", "The state is current all the time.", std::nullopt,
                 seconds("until", std::nullopt, "until when")),
      make_claim("never", "The state is current at no time.", Value(0.0),
                 seconds("until", Value(kLongestExpectation_s), "until when"))};
  return specs;
}

}  // namespace galilean::bhdl
