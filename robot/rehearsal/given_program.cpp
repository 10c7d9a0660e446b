// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rehearsal/given_program.h"

#include <algorithm>
#include <unordered_map>

#include "robot/rehearsal/given_schemas.h"

namespace galilean::robot {
namespace {

// No text of a program holds a line end, so that no schema of the program has such a name.
std::string name_of(std::size_t given) {
  return "given\n" + std::to_string(given);
}

ComponentKind kind_of(const bhdl::Given& given) noexcept {
  return given.type == variable_type_name<Force>() ? ComponentKind::kMotorSchema
                                                   : ComponentKind::kPerceptualSchema;
}

bhdl::Component component_of(const bhdl::Given& given, std::size_t number) {
  AttributeValues values;
  values.set(given.type + "_variable", given.variable);
  if (given.type == variable_type_name<Bits>()) {
    values.set("bit_index", static_cast<double>(given.bit_index));
    values.set("bit_value", given.bit_value);
  } else if (given.type == variable_type_name<Force>()) {
    values.set("value", given.force);
  } else {
    values.set("position", given.position_m);
    if (given.type == variable_type_name<Shaft>()) values.set("heading", given.heading_rad);
  }
  values.set("valid", given.valid);
  values.set("from", given.from_s);
  values.set("until", given.until_s);
  return {given_schema(given.type), name_of(number), kind_of(given), std::move(values),
          given.location};
}

bool names(const Value& value, const std::string& variable) {
  if (const auto* one = std::get_if<std::string>(&value)) return *one == variable;
  const auto* several = std::get_if<std::vector<std::string>>(&value);
  return several != nullptr && std::ranges::find(*several, variable) != several->end();
}

bool writes(const bhdl::Component& schema, const std::string& variable, const Catalog& catalog) {
  const ComponentSpec* spec = catalog.find(schema.type);
  return spec != nullptr &&
         std::ranges::any_of(spec->attributes, [&](const AttributeSpec& attribute) {
           const Value* value = schema.attributes.find(attribute.name);
           const bool written =
               attribute.access == Access::kWrite || attribute.access == Access::kUpdate;
           return written && value != nullptr && names(*value, variable);
         });
}

using Givens = std::vector<bhdl::Given>;

/// Inserts the schemas of the givens into a state's list: before all schemas, and again behind each
/// schema that writes the variable.
class Interleaver {
 public:
  Interleaver(const Givens& givens, ComponentKind kind, const std::vector<bhdl::Component>& schemas,
              const Catalog& catalog) {
    for (std::size_t i = 0; i < givens.size(); ++i) {
      if (kind_of(givens[i]) != kind) continue;
      first_.push_back(name_of(i));
      for (const auto& schema : schemas)
        if (writes(schema, givens[i].variable, catalog)) behind_[schema.name].push_back(name_of(i));
    }
  }

  void add_to(std::vector<std::string>& list) const {
    std::vector<std::string> result = first_;
    for (const auto& name : list) {
      result.push_back(name);
      if (const auto found = behind_.find(name); found != behind_.end())
        result.insert(result.end(), found->second.begin(), found->second.end());
    }
    list = std::move(result);
  }

 private:
  std::vector<std::string> first_;
  std::unordered_map<std::string, std::vector<std::string>> behind_;
};

}  // namespace

bhdl::Program with_givens(bhdl::Program program, const bhdl::Expectation& expectation,
                          const Catalog& catalog) {
  const auto& givens = expectation.givens;
  const Interleaver perceptual(givens, ComponentKind::kPerceptualSchema, program.perceptual_schemas,
                               catalog);
  const Interleaver motor(givens, ComponentKind::kMotorSchema, program.motor_schemas, catalog);
  for (auto& state : program.states) {
    perceptual.add_to(state.perceptual_schemas);
    motor.add_to(state.motor_schemas);
  }
  for (std::size_t i = 0; i < givens.size(); ++i)
    (kind_of(givens[i]) == ComponentKind::kMotorSchema ? program.motor_schemas
                                                       : program.perceptual_schemas)
        .push_back(component_of(givens[i], i));
  if (!expectation.from_state.empty()) program.start_state = expectation.from_state;
  return program;
}

}  // namespace galilean::robot
