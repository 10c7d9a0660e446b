// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// The component that an attribute belongs to. It is put into words only where something is wrong.
struct AttributeContext {
  const Word& type;
  const std::vector<AttributeNode>& attributes;
};

/// Returns the words for messages, such as "locate 'trash'".
[[nodiscard]] std::string label(const AttributeContext& context);
/// Returns the name that the attributes give, or nullptr.
[[nodiscard]] const ValueNode* given_name(const std::vector<AttributeNode>& attributes) noexcept;

}  // namespace galilean::bhdl
