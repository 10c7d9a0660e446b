// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/bit_meaning.h"

#include <set>

#include "bhdl/check/attribute_context.h"
#include "bhdl/source/text.h"
#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean::bhdl::lsp {
namespace {

const AttributeNode* find_given(const std::vector<AttributeNode>& given, const AttributeSpec& spec,
                                const ComponentSpec& component) {
  for (const auto& attribute : given)
    if (component.find(attribute.name.text) == &spec && !attribute.values.empty())
      return &attribute;
  return nullptr;
}

const AttributeSpec* bits_attribute(const ComponentSpec& component) {
  for (const auto& attribute : component.attributes)
    if (attribute.refers_to == variable_type_name<Bits>()) return &attribute;
  return nullptr;
}

bool writes(Access access) {
  return access == Access::kWrite || access == Access::kUpdate;
}

double number_given(const Entity& entity, const AttributeSpec& spec) {
  if (const AttributeNode* node = find_given(entity.attributes, spec, *entity.spec))
    return node->values.front().number;
  const auto* default_value =
      spec.default_value ? std::get_if<double>(&*spec.default_value) : nullptr;
  return default_value == nullptr ? -1 : *default_value;
}

// A schema without an attribute for the bit writes all bits of its variable.
bool writes_bit(const Entity& entity, const AttributeSpec& target, const BitAt& bit) {
  const AttributeNode* node = find_given(entity.attributes, target, *entity.spec);
  if (node == nullptr || node->values.front().text != bit.variable) return false;
  for (const auto& attribute : entity.spec->attributes) {
    if (attribute.bit_of != target.name) continue;
    const double index = number_given(entity, attribute);
    return index < 0 || index == bit.index;
  }
  return true;
}

void add_writer(const Entity& entity, const BitAt& bit, std::set<std::string>& lines) {
  if (entity.spec == nullptr || !entity.space || *entity.space == NameSpace::kState) return;
  for (const auto& attribute : entity.spec->attributes)
    if (attribute.refers_to == variable_type_name<Bits>() && writes(attribute.access) &&
        writes_bit(entity, attribute, bit))
      lines.insert("- written by " + label({entity.type, entity.attributes}) + ": " +
                   entity.spec->help + "\n");
}

}  // namespace

std::optional<BitAt> bit_at(const Spot& spot) {
  if (spot.attribute == nullptr || spot.attribute->type != AttributeType::kInteger) return {};
  const bool says_which = !spot.attribute->bit_of.empty() || spot.attribute->name == "bit_index";
  const AttributeSpec* bits = bits_attribute(*spot.component);
  if (!says_which || bits == nullptr) return {};
  const AttributeNode* variable = find_given(*spot.given, *bits, *spot.component);
  const AttributeNode* index = find_given(*spot.given, *spot.attribute, *spot.component);
  if (variable == nullptr || index == nullptr) return {};
  return BitAt{std::string(variable->values.front().text),
               static_cast<int>(std::clamp(index->values.front().number, -1.0, 1e6))};
}

std::string writers_in_words(const Session& session, const std::string& path, const BitAt& bit) {
  std::set<std::string> lines;
  for (const auto& program : session.workspace.programs_with(path))
    for (const auto& file : program)
      for_each_entity(file->tree(), session.vocabulary,
                      [&](const Entity& entity) { add_writer(entity, bit, lines); });
  std::string text;
  for (const auto& line : lines) text += line;
  return text.empty() ? "No schema of this program writes it.\n" : text;
}

}  // namespace galilean::bhdl::lsp
