// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/device_check.h"

#include <set>
#include <string>
#include <unordered_set>

#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

std::set<std::string> devices_named(const Program& program, const Vocabulary& vocabulary) {
  std::set<std::string> devices;
  for (const auto& device : program.devices)
    if (const ComponentSpec* spec = vocabulary.find(device.type)) devices.insert(spec->device());
  return devices;
}

std::unordered_set<const SchemaUse*> schemas_of_states(const Program& program,
                                                       const SchemaUses& uses) {
  std::unordered_set<const SchemaUse*> listed;
  for (std::size_t state = 0; state < program.states.size(); ++state)
    for (const auto* schemas : {&uses.listed(state).perceptual, &uses.listed(state).motor})
      listed.insert(schemas->begin(), schemas->end());
  return listed;
}

std::string section_of(const std::string& device, const Vocabulary& vocabulary) {
  const ComponentSpec* spec = vocabulary.find(device);
  const bool output = spec != nullptr && spec->kind == ComponentKind::kOutputDevice;
  return output ? "output_devices" : "input_devices";
}

}  // namespace

void warn_of_unnamed_devices(const Program& program, const SchemaUses& uses,
                             const Vocabulary& vocabulary, Diagnostics& diagnostics) {
  std::set<std::string> known = devices_named(program, vocabulary);
  const auto listed = schemas_of_states(program, uses);
  for (const SchemaUse& use : uses.all()) {
    if (!listed.contains(&use)) continue;
    for (const std::string& device : use.spec->needs) {
      if (!known.insert(device).second) continue;
      diagnostics.warning(
          use.component->location, "device/unnamed",
          use.component->type + " " + in_quotes(use.component->name) + " needs the " + device +
              ", which the program does not name: a robot takes it with the default settings",
          "name it: " + section_of(device, vocabulary) + ": " + device + ": end end");
    }
  }
}

}  // namespace galilean::bhdl
