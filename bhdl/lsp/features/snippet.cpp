// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/snippet.h"

namespace galilean::bhdl::lsp {
namespace {

std::string place(int& next) {
  return "$" + std::to_string(next++);
}

bool is_schema_list(const AttributeSpec& spec) {
  return spec.refers_to == "perceptual_schema" || spec.refers_to == "motor_schema";
}

}  // namespace

std::string value_snippet(const AttributeSpec& spec, int& next) {
  switch (spec.type) {
    case AttributeType::kText:
    case AttributeType::kName:
    case AttributeType::kChoice:
    case AttributeType::kNames:
      return "\"" + place(next) + "\"" + (is_schema_list(spec) ? " end" : "");
    case AttributeType::kPair: {
      const std::string first = place(next);
      return "<" + first + ", " + place(next) + ">";
    }
    default:
      return place(next);
  }
}

std::string component_snippet(const ComponentSpec& spec, bool is_variable) {
  const std::string_view gap = is_variable ? "  " : "\n  ";
  std::string text = spec.name + ":";
  int next = 1;
  for (const auto& attribute : spec.attributes)
    if (attribute.required() || is_schema_list(attribute))
      text.append(gap).append(attribute.name + ": " + value_snippet(attribute, next));
  if (is_variable) return text;
  return text + (next == 1 ? " end" : "\nend");
}

}  // namespace galilean::bhdl::lsp
