// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/owner.h"

#include "bhdl/source/text.h"

namespace galilean::bhdl {

const ValueNode* given_name(const std::vector<AttributeNode>& attributes) noexcept {
  for (const auto& attribute : attributes)
    if (attribute.name.text == "name" && attribute.values.size() == 1 &&
        attribute.values.front().kind == ValueNode::Kind::kText)
      return &attribute.values.front();
  return nullptr;
}

std::string label(const Owner& owner) {
  const ValueNode* name = given_name(owner.attributes);
  return std::string(owner.type.text) +
         (name == nullptr ? std::string() : " " + in_quotes(name->text));
}

}  // namespace galilean::bhdl
