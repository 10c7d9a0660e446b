// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/schema_use.h"

namespace galilean::bhdl {
namespace {

using UsesByName = std::unordered_map<std::string_view, const SchemaUse*>;

std::vector<const SchemaUse*> uses_of(const std::vector<std::string>& list,
                                      const UsesByName& names) {
  std::vector<const SchemaUse*> uses;
  for (const auto& name : list)
    if (const auto found = names.find(name); found != names.end()) uses.push_back(found->second);
  return uses;
}

/// Returns the bits that the attributes with `bit_of` name, or all bits if no attribute has it.
std::uint32_t bits_written(const Component& component, const ComponentSpec& spec,
                           const std::string& variable_attribute) {
  constexpr double kLastBit = 31;
  std::uint32_t bits = 0;
  for (const auto& attribute : spec.attributes) {
    if (attribute.bit_of != variable_attribute) continue;
    const Value* value = component.attributes.find(attribute.name);
    const auto* index = value == nullptr ? nullptr : std::get_if<double>(value);
    if (index == nullptr || *index < 0 || *index > kLastBit) return ~std::uint32_t{0};
    bits |= std::uint32_t{1} << static_cast<unsigned>(*index);
  }
  return bits == 0 ? ~std::uint32_t{0} : bits;
}

}  // namespace

SchemaUses::SchemaUses(const Program& program, const Vocabulary& vocabulary) {
  for (const auto& variable : program.variables)
    variables_.emplace(variable.name, variables_.size());
  for (const auto& each : program.perceptual_schemas) add(each, vocabulary);
  for (const auto& each : program.motor_schemas) add(each, vocabulary);
  UsesByName perceptual;
  UsesByName motor;
  for (const auto& use : all_) {
    const bool moves = use.component->kind == ComponentKind::kMotorSchema;
    (moves ? motor : perceptual).emplace(use.component->name, &use);
  }
  for (const auto& state : program.states)
    listed_.push_back(
        {uses_of(state.perceptual_schemas, perceptual), uses_of(state.motor_schemas, motor)});
}

void SchemaUses::add(const Component& component, const Vocabulary& vocabulary) {
  SchemaUse use{.component = &component, .spec = vocabulary.find(component.type)};
  for (const auto& attribute : use.spec->attributes) {
    if (attribute.type != AttributeType::kName && attribute.type != AttributeType::kNames) continue;
    const Value* value = component.attributes.find(attribute.name);
    const Access access = attribute.access;
    if (access == Access::kNone) add_names(value, use.adjusts);
    if (access == Access::kRead || access == Access::kUpdate) add_names(value, use.reads);
    if (access == Access::kWrite) add_names(value, use.writes);
    if (access == Access::kUpdate) add_names(value, use.updates);
    if (access != Access::kWrite && access != Access::kUpdate) continue;
    std::vector<std::size_t> written;
    add_names(value, written);
    for (const std::size_t variable : written)
      use.written.push_back({variable, bits_written(component, *use.spec, attribute.name)});
  }
  all_.push_back(std::move(use));
}

void SchemaUses::add_names(const Value* value, std::vector<std::size_t>& into) const {
  const auto add_one = [&](const std::string& name) {
    if (const auto found = variables_.find(name); found != variables_.end())
      into.push_back(found->second);
  };
  if (value == nullptr) return;
  if (const auto* one = std::get_if<std::string>(value)) add_one(*one);
  if (const auto* several = std::get_if<std::vector<std::string>>(value))
    for (const auto& each : *several) add_one(each);
}

}  // namespace galilean::bhdl
