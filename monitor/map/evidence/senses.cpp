#include "monitor/map/evidence/senses.h"

#include <algorithm>
#include <utility>

#include "bhdl/check.h"

namespace galilean::monitor {
namespace {

/// The names of all schemas for which it holds.
std::set<std::string> names_of(const std::vector<bhdl::Component>& schemas, auto&& holds) {
  std::set<std::string> names;
  for (const auto& schema : schemas)
    if (holds(schema)) names.insert(schema.name);
  return names;
}

bool opens_gripper(const bhdl::Component& schema) {
  const auto* command = schema.attributes.find("command");
  const auto* word = command ? std::get_if<std::string>(command) : nullptr;
  return schema.type == "move_gripper" && word && *word == "open";
}

bool has_one_of(const std::vector<std::string>& list, const std::set<std::string>& names) {
  return std::ranges::any_of(list, [&](const auto& name) { return names.contains(name); });
}

}  // namespace

void Senses::note(const msg::Program& program, const Catalog& catalog) {
  gripper_.reset();
  lets_go_.clear();
  bumpers_.clear();
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : program.files) files.push_back({file.path, file.text});
  const auto checked = bhdl::check(std::move(files), catalog);
  if (!checked.program) return;
  note_states(*checked.program);
  for (const auto& schema : checked.program->perceptual_schemas) {
    const auto* variable = schema.attributes.find("bits_variable");
    if (!variable) continue;
    const auto name = std::get<std::string>(*variable);
    if (schema.type == "bumper_scanner") bumpers_ = name;
    if (schema.type != "gripper_scanner") continue;
    const auto* beam = schema.attributes.find("beam_index");
    if (beam) gripper_ = GripperBits{name, static_cast<unsigned>(std::get<double>(*beam))};
  }
}

void Senses::note_states(const bhdl::Program& program) {
  const auto openers = names_of(program.motor_schemas, opens_gripper);
  const auto scanners = names_of(program.perceptual_schemas, [](const bhdl::Component& schema) {
    return schema.type == "gripper_scanner";
  });
  for (const auto& state : program.states)
    if (has_one_of(state.motor_schemas, openers) && !has_one_of(state.perceptual_schemas, scanners))
      lets_go_.insert(state.name);
}

void Senses::note(const msg::Variables& variables, Time now) {
  std::uint32_t gripper_bits = 0;
  for (const auto& variable : variables.items) {
    if (variable.type != msg::Variable_Constants::BITS || !variable.valid ||
        variable.values.empty())
      continue;
    const auto bits = static_cast<std::uint32_t>(variable.values.front());
    if (variable.name == bumpers_ && bits != 0) touched_ = now;
    if (gripper_ && variable.name == gripper_->variable) gripper_bits = bits;
  }
  note_gripper(gripper_bits, now);
}

void Senses::note_gripper(std::uint32_t bits, Time now) {
  const bool beam_broken = gripper_ && (bits >> gripper_->beam & 1);
  if (beam_broken && !beam_broken_) since_ = now;
  beam_broken_ = beam_broken;
}

}  // namespace galilean::monitor
