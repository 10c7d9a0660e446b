// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/idle_check.h"

#include <algorithm>
#include <unordered_set>

#include "bhdl/program/initial_value.h"
#include "bhdl/source/text.h"
#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean::bhdl {
namespace {

std::string idle_schema_in_words(const Component& component) {
  return component.type + " " + in_quotes(component.name);
}

/// Returns the types of variable that a schema of the catalog can write. The robot itself writes
/// the others.
std::unordered_set<std::string_view> types_written(const Vocabulary& vocabulary) {
  std::unordered_set<std::string_view> types;
  for (const auto& component : vocabulary.components())
    for (const auto& attribute : component.attributes)
      if (attribute.access == Access::kWrite || attribute.access == Access::kUpdate)
        types.insert(attribute.refers_to);
  return types;
}

std::vector<bool> written_variables(const Program& program, const SchemaUses& uses) {
  std::vector<bool> written(program.variables.size());
  for (const auto& use : uses.all())
    for (const auto* variables : {&use.writes, &use.updates})
      for (const std::size_t variable : *variables) written[variable] = true;
  return written;
}

std::unordered_set<const Component*> listed_schemas(const Program& program,
                                                    const SchemaUses& uses) {
  std::unordered_set<const Component*> listed;
  for (std::size_t i = 0; i < program.states.size(); ++i)
    for (const auto* schemas : {&uses.listed(i).perceptual, &uses.listed(i).motor})
      for (const auto* use : *schemas) listed.insert(use->component);
  return listed;
}

bool is_extended(const Component& schema, const ExtendedNames& extended) {
  const bool moves = schema.kind == ComponentKind::kMotorSchema;
  return (moves ? extended.motor_schemas : extended.perceptual_schemas).contains(schema.name);
}

// The catalog shows which attributes are gains: a list of numbers, one for each entry of another
// list.
void warn_of_zero_gains(const SchemaUse& use, Diagnostics& diagnostics) {
  for (const auto& attribute : use.spec->attributes) {
    if (attribute.type != AttributeType::kNumbers || attribute.one_for_each.empty()) continue;
    const Value* gains = use.component->attributes.find(attribute.name);
    const Value* inputs = use.component->attributes.find(attribute.one_for_each);
    if (gains == nullptr || inputs == nullptr) continue;
    const auto& numbers = std::get<std::vector<double>>(*gains);
    const auto& names = std::get<std::vector<std::string>>(*inputs);
    for (std::size_t i = 0; i < std::min(numbers.size(), names.size()); ++i)
      if (numbers[i] == 0)
        diagnostics.warning(
            use.component->location, "value/no-effect",
            in_quotes(names[i]) + " has no effect in " + idle_schema_in_words(*use.component) +
                ": its entry in " + in_quotes(attribute.name) + " is 0",
            "take it out of " + in_quotes(attribute.one_for_each) + ", or give it another number");
  }
}

std::vector<bool> read_variables(const Program& program, const SchemaUses& uses) {
  std::vector<bool> read(program.variables.size());
  for (const auto& use : uses.all())
    for (const std::size_t variable : use.reads) read[variable] = true;
  return read;
}

bool writes_a_force(const Program& program, const SchemaUse& use) {
  return std::ranges::any_of(use.written, [&](const WrittenBits& written) {
    return program.variables[written.variable].type == variable_type_name<Force>();
  });
}

// Says how to make something read a force: add it to a schema that combines forces, if the catalog
// has one.
std::string way_to_be_read(const Vocabulary& vocabulary) {
  for (const auto& component : vocabulary.components())
    if (const auto* gains = component.find(Role::kGain))
      return "add its force to the " + gains->of + " of " + component.name +
             ", or take the gain away";
  return "take the gain away";
}

// Warns of a schema's own gain, which the catalog gives every motor schema.
void warn_of_idle_gain(const Program& program, const SchemaUse& use, const std::vector<bool>& read,
                       const Vocabulary& vocabulary, Diagnostics& diagnostics) {
  const Value* value = use.component->attributes.find(kGainAttribute);
  if (use.component->kind != ComponentKind::kMotorSchema || value == nullptr) return;
  const double gain = std::get<double>(*value);
  const auto warn = [&](const std::string& why, const std::string& hint) {
    diagnostics.warning(use.component->location, "value/no-effect",
                        "the gain of " + idle_schema_in_words(*use.component) + " " + why, hint);
  };
  const bool is_read = std::ranges::any_of(
      use.written, [&](const WrittenBits& written) { return read[written.variable]; });
  if (gain == 1) return;
  if (!writes_a_force(program, use))
    warn("has no effect: it writes no force", "take it away");
  else if (!is_read)
    warn("has no effect: no schema reads its force", way_to_be_read(vocabulary));
  else if (gain == 0)
    warn("is 0, and so its force has no effect",
         "take the schema out of the states, or give it another gain");
}

}  // namespace

void warn_of_unwritten_variables(const Program& program, const SchemaUses& uses,
                                 const Vocabulary& vocabulary, Diagnostics& diagnostics) {
  const auto types = types_written(vocabulary);
  const auto listed = listed_schemas(program, uses);
  std::vector<bool> done = written_variables(program, uses);
  for (const auto& use : uses.all()) {
    if (!listed.contains(use.component)) continue;
    for (const std::size_t index : use.reads) {
      const Component& variable = program.variables[index];
      if (done[index] || starts_valid(variable) || !types.contains(variable.type)) continue;
      done[index] = true;
      diagnostics.warning(variable.location, "variable/never-written",
                          "no schema writes " + in_quotes(variable.name) + ", which " +
                              idle_schema_in_words(*use.component) +
                              " reads: it never becomes valid",
                          "add a schema that writes it, or make it valid from the start");
    }
  }
}

void warn_of_unused_schemas(const Program& program, const SchemaUses& uses, const ProgramText& text,
                            Diagnostics& diagnostics) {
  const auto listed = listed_schemas(program, uses);
  for (const auto& use : uses.all())
    if (use.component->location.file == text.main_file && !listed.contains(use.component) &&
        !is_extended(*use.component, text.extended))
      diagnostics.warning(use.component->location, "schema/unused",
                          "no state lists " + idle_schema_in_words(*use.component),
                          "list it in a state, or take it away");
}

void warn_of_gains_without_effect(const Program& program, const SchemaUses& uses,
                                  const Vocabulary& vocabulary, Diagnostics& diagnostics) {
  const auto read = read_variables(program, uses);
  for (const auto& use : uses.all()) {
    warn_of_zero_gains(use, diagnostics);
    warn_of_idle_gain(program, use, read, vocabulary, diagnostics);
  }
}

}  // namespace galilean::bhdl
