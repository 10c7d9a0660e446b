// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// What an attribute belongs to. It is put in words only where something is wrong.
struct Owner {
  const Word& type;
  const std::vector<AttributeNode>& attributes;
};

/// "locate 'trash'", as messages call it.
[[nodiscard]] std::string label(const Owner& owner);
/// The name that the attributes give, or nullptr.
[[nodiscard]] const ValueNode* given_name(const std::vector<AttributeNode>& attributes) noexcept;

}  // namespace galilean::bhdl
