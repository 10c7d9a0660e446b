// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/state_specs.h"

#include "bhdl/program/program.h"
#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean::bhdl {
namespace {

constexpr double kLastBit = 31;

AttributeSpec schemas(std::string name, std::vector<std::string> aliases, std::string kind,
                      std::string help) {
  return {.name = std::move(name),
          .aliases = std::move(aliases),
          .type = AttributeType::kNames,
          .default_value = Value(std::vector<std::string>{}),
          .refers_to = std::move(kind),
          .help = std::move(help)};
}

std::vector<std::string> bit_updates() {
  std::vector<std::string> words;
  for (auto each : {BitUpdate::kSame, BitUpdate::kSet, BitUpdate::kClear, BitUpdate::kToggle})
    words.emplace_back(to_string(each));
  return words;
}

ComponentSpec make_state() {
  return {.name = "state",
          .help =
              "A step of the task: the schemas that are active in it, in the order in which "
              "they run, and the conditions under which it is left.",
          .attributes = {name_spec(),
                         schemas("perceptual_schemas", {"percp_schemas"}, "perceptual_schema",
                                 "perceptual schemas that run in it; closed by its own end"),
                         schemas("motor_schemas", {}, "motor_schema",
                                 "motor schemas that run in it; closed by its own end")}};
}

ComponentSpec make_condition() {
  return {
      .name = "condition",
      .help =
          "A way out of the state that holds it. Conditions are tried in the order of the text "
          "and the first that holds fires; one on an invalid variable never holds.",
      .attributes = {
          {.name = "bits_variable",
           .type = AttributeType::kName,
           .refers_to = variable_type_name<Bits>(),
           .access = Access::kUpdate,
           .help = "the variable whose bit is tested"},
          {.name = "bit_index",
           .type = AttributeType::kInteger,
           .default_value = Value(0.0),
           .minimum = 0,
           .maximum = kLastBit,
           .help = "which of its bits"},
          {.name = "bit_value",
           .type = AttributeType::kFlag,
           .default_value = Value(true),
           .help = "what the bit must be for the condition to hold"},
          {.name = "bit_update",
           .type = AttributeType::kChoice,
           .default_value = Value(std::string(to_string(BitUpdate::kSame))),
           .choices = bit_updates(),
           .help = "what becomes of the bit when the condition fires"},
          {.name = "new_state",
           .type = AttributeType::kName,
           .refers_to = "state",
           .help = "the state that is entered"},
          {.name = "reset_variables",
           .type = AttributeType::kNames,
           .default_value = Value(std::vector<std::string>{}),
           .refers_to = "variable",
           .access = Access::kWrite,
           .help = "variables that become invalid, with certainty 0, when the condition fires"}}};
}

}  // namespace

const AttributeSpec& name_spec() {
  static const AttributeSpec spec{.name = "name",
                                  .type = AttributeType::kText,
                                  .help = "the name by which the rest of the program refers to it"};
  return spec;
}

const ComponentSpec& state_spec() {
  static const ComponentSpec spec = make_state();
  return spec;
}

const ComponentSpec& condition_spec() {
  static const ComponentSpec spec = make_condition();
  return spec;
}

}  // namespace galilean::bhdl
