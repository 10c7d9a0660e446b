// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/attribute_context.h"

#include "bhdl/source/text.h"

namespace galilean::bhdl {

const ValueNode* given_name(const std::vector<AttributeNode>& attributes) noexcept {
  for (const auto& attribute : attributes)
    if (attribute.name.text == "name" && attribute.values.size() == 1 &&
        attribute.values.front().kind == ValueNode::Kind::kText)
      return &attribute.values.front();
  return nullptr;
}

std::string label(const AttributeContext& context) {
  const ValueNode* name = given_name(context.attributes);
  return std::string(context.type.text) +
         (name == nullptr ? std::string() : " " + in_quotes(name->text));
}

}  // namespace galilean::bhdl
