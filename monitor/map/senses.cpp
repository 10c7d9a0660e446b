#include "monitor/map/senses.h"

#include <utility>

#include "bhdl/check.h"

namespace galilean::monitor {

void Senses::note(const msg::Program& program, const Catalog& catalog) {
  gripper_.reset();
  bumpers_.clear();
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : program.files) files.push_back({file.path, file.text});
  const auto checked = bhdl::check(std::move(files), catalog);
  if (!checked.program) return;
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
