// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/constant_roles.h"

namespace galilean::bhdl::lsp {
namespace {

void note_uses(const ParsedFile& file, ConstantRoles& roles) {
  for (const auto& mention : file.mentions().names)
    if (mention.space == NameSpace::kConstant && mention.referenced_space)
      roles[mention.name].set(static_cast<std::size_t>(*mention.referenced_space));
}

// If a constant uses another in its definition, what the first names the second names, too. Returns
// whether anything changed.
bool propagate(const ParsedFile& file, ConstantRoles& roles) {
  bool changed = false;
  for (const auto& defined : file.mentions().defined) {
    const auto user = roles.find(defined.constant);
    if (defined.is_text || user == roles.end()) continue;
    const Roles propagated = user->second;
    Roles& known = roles[defined.value];
    changed = changed || (known | propagated) != known;
    known |= propagated;
  }
  return changed;
}

}  // namespace

ConstantRoles constant_roles(const ProgramFiles& program) {
  constexpr int kDeepestChain = 64;
  ConstantRoles roles;
  for (const auto& file : program) note_uses(*file, roles);
  bool changed = true;
  for (int depth = 0; changed && depth < kDeepestChain; ++depth) {
    changed = false;
    for (const auto& file : program) changed = propagate(*file, roles) || changed;
  }
  return roles;
}

}  // namespace galilean::bhdl::lsp
