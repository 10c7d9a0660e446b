// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/contact_sensors.h"

#include <algorithm>
#include <utility>

#include "bhdl/check.h"

namespace galilean::monitor {
namespace {

/// Returns the names of the schemas for which `holds` is true.
std::set<std::string> names_of(const std::vector<bhdl::Component>& schemas, auto&& holds) {
  std::set<std::string> names;
  for (const auto& schema : schemas)
    if (holds(schema)) names.insert(schema.name);
  return names;
}

bool has_role(const bhdl::Component& schema, Role role, const Catalog& catalog) {
  const ComponentSpec* spec = catalog.find(schema.type);
  return spec != nullptr && spec->find(role) != nullptr;
}

bool opens_gripper(const bhdl::Component& schema, const Catalog& catalog) {
  const ComponentSpec* spec = catalog.find(schema.type);
  const AttributeSpec* attribute = spec ? spec->find(Role::kGripperCommand) : nullptr;
  const auto* command = attribute ? schema.attributes.find(attribute->name) : nullptr;
  const auto* word = command ? std::get_if<std::string>(command) : nullptr;
  return word && *word == "open";
}

/// Returns the mask of the bit at `index`. Returns all bits for an index below 0, and none for one
/// above 31, which only a catalog with wrong limits allows.
std::uint32_t mask_of(double index) {
  constexpr double kLastBit = 31;
  if (index < 0) return ~std::uint32_t{0};
  return index > kLastBit ? 0 : std::uint32_t{1} << static_cast<unsigned>(index);
}

/// Returns the value of a bits variable; 0 if it is none that such a variable can have.
std::uint32_t bits_of(const msg::Variable& variable) {
  constexpr double kMost = 4294967295.0;
  const double value = variable.values.front();
  return value >= 0 && value <= kMost ? static_cast<std::uint32_t>(value) : 0;
}

bool has_one_of(const std::vector<std::string>& list, const std::set<std::string>& names) {
  return std::ranges::any_of(list, [&](const auto& name) { return names.contains(name); });
}

}  // namespace

void ContactSensors::set_program(const msg::Program& program, const Catalog& catalog) {
  beam_.clear();
  opens_.clear();
  bumpers_.clear();
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : program.files) files.push_back({file.path, file.text});
  const auto checked = bhdl::check(std::move(files), catalog);
  if (!checked.program) return;
  note_states(*checked.program, catalog);
  for (const auto& schema : checked.program->perceptual_schemas) note_bits(schema, catalog);
}

void ContactSensors::note_bits(const bhdl::Component& schema, const Catalog& catalog) {
  const ComponentSpec* spec = catalog.find(schema.type);
  if (spec == nullptr) return;
  for (const auto& attribute : spec->attributes) {
    if (attribute.role != Role::kBumper && attribute.role != Role::kGripperBeam) continue;
    const auto* variable = schema.attributes.find(attribute.bit_of);
    const auto* index = schema.attributes.find(attribute.name);
    if (variable == nullptr || index == nullptr) continue;
    auto& sensors = attribute.role == Role::kBumper ? bumpers_ : beam_;
    sensors.push_back({std::get<std::string>(*variable), mask_of(std::get<double>(*index))});
  }
}

void ContactSensors::note_states(const bhdl::Program& program, const Catalog& catalog) {
  const auto openers = names_of(program.motor_schemas, [&](const bhdl::Component& schema) {
    return opens_gripper(schema, catalog);
  });
  const auto scanners = names_of(program.perceptual_schemas, [&](const bhdl::Component& schema) {
    return has_role(schema, Role::kGripperBeam, catalog);
  });
  for (const auto& state : program.states)
    if (has_one_of(state.motor_schemas, openers) && !has_one_of(state.perceptual_schemas, scanners))
      opens_.insert(state.name);
}

void ContactSensors::update(const msg::Variables& variables, Time now) {
  bool beam_broken = false;
  for (const auto& variable : variables.items) {
    if (variable.type != msg::Variable_Constants::BITS || !variable.valid ||
        variable.values.empty())
      continue;
    const std::uint32_t bits = bits_of(variable);
    const auto is_set = [&](const SensorBits& sensor) {
      return sensor.variable == variable.name && (bits & sensor.mask) != 0;
    };
    if (std::ranges::any_of(bumpers_, is_set)) touched_ = now;
    beam_broken = beam_broken || std::ranges::any_of(beam_, is_set);
  }
  if (beam_broken && !beam_broken_) broken_since_ = now;
  beam_broken_ = beam_broken;
}

}  // namespace galilean::monitor
