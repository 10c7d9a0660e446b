#include "monitor/map/grasp.h"

#include <cstdint>

#include "bhdl/check.h"

namespace galilean::monitor {

void Grasp::note(const msg::Program& program, const Catalog& catalog) {
  bits_.reset();
  std::vector<bhdl::SourceFile> files;
  for (const auto& file : program.files) files.push_back({file.path, file.text});
  const auto checked = bhdl::check(std::move(files), catalog);
  if (!checked.program) return;
  for (const auto& schema : checked.program->perceptual_schemas) {
    if (schema.type != "gripper_scanner") continue;
    const auto* variable = schema.attributes.find("bits_variable");
    const auto* beam = schema.attributes.find("beam_index");
    const auto* closed = schema.attributes.find("closed_index");
    if (variable && beam && closed)
      bits_ = Bits{std::get<std::string>(*variable), static_cast<unsigned>(std::get<double>(*beam)),
                   static_cast<unsigned>(std::get<double>(*closed))};
  }
}

void Grasp::note(const msg::Variables& variables, Time now) {
  bool closed_on_something = false;
  for (const auto& variable : variables.items) {
    if (!bits_ || variable.name != bits_->variable || !variable.valid || variable.values.empty())
      continue;
    const auto bits = static_cast<std::uint32_t>(variable.values.front());
    closed_on_something = (bits >> bits_->beam & 1) && (bits >> bits_->closed & 1);
  }
  if (closed_on_something && !closed_on_something_) since_ = now;
  closed_on_something_ = closed_on_something;
}

}  // namespace galilean::monitor
