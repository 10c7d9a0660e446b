// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <string_view>
#include <unordered_map>

#include "bhdl/lsp/documents/workspace.h"

namespace galilean::bhdl::lsp {

/// The kinds of names that a constant's texts may be, by where the constant is used. A constant
/// among motor schemas names motor schemas. There is one bit for each NameSpace.
using Roles = std::bitset<8>;
using ConstantRoles = std::unordered_map<std::string_view, Roles>;

/// Returns the roles of every constant in a program. The keys point into its files.
[[nodiscard]] ConstantRoles constant_roles(const ProgramFiles& program);

[[nodiscard]] inline bool has_role(const ConstantRoles& roles, std::string_view constant,
                                   NameSpace space) {
  const auto found = roles.find(constant);
  return found != roles.end() && found->second.test(static_cast<std::size_t>(space));
}

}  // namespace galilean::bhdl::lsp
