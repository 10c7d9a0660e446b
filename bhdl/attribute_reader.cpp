#include "bhdl/attribute_reader.h"

#include <ranges>
#include <unordered_set>

#include "bhdl/names.h"
#include "bhdl/text.h"
#include "bhdl/value_reader.h"
#include "bhdl/vocabulary.h"

namespace galilean::bhdl {

const ValueNode* given_name(const std::vector<AttributeNode>& attributes) noexcept {
  for (const auto& attribute : attributes)
    if (attribute.name.text == "name" && attribute.values.size() == 1 &&
        attribute.values.front().kind == ValueNode::Kind::kText)
      return &attribute.values.front();
  return nullptr;
}

std::string label(const Word& type, const std::vector<AttributeNode>& attributes) {
  const ValueNode* name = given_name(attributes);
  return std::string(type.text) + (name == nullptr ? std::string() : " " + in_quotes(name->text));
}

AttributeValues AttributeReader::read(const ComponentSpec& spec, const Word& type,
                                      const std::vector<AttributeNode>& attributes) const {
  const std::string owner = label(type, attributes);
  std::vector<const Word*> given(spec.attributes.size(), nullptr);
  AttributeValues values;
  for (const auto& attribute : attributes) {
    const AttributeSpec* known = spec.find(attribute.name.text);
    if (known == nullptr) {
      refuse_unknown(spec, attribute.name);
      continue;
    }
    const Word*& first = given[static_cast<std::size_t>(known - spec.attributes.data())];
    if (first != nullptr) {
      diagnostics_.error(attribute.name.at, "name/duplicate-attribute",
                         in_quotes(known->name) + " of " + owner +
                             " is given twice: the first is at " + place(first->at));
      continue;
    }
    first = &attribute.name;
    if (attribute.name.text != known->name) warn_of_alias(*known, attribute.name);
    if (auto value = read_value(attribute, *known, owner, diagnostics_)) {
      check_names(attribute, *known, owner);
      values.set(known->name, std::move(*value));
    }
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    const AttributeSpec& each = spec.attributes[i];
    if (given[i] != nullptr) continue;
    if (each.default_value)
      values.set(each.name, to_si(*each.default_value, each.unit));
    else
      refuse_missing(each, type, owner);
  }
  return values;
}

void AttributeReader::check_names(const AttributeNode& attribute, const AttributeSpec& spec,
                                  const std::string& owner) const {
  if (spec.type != AttributeType::kName && spec.type != AttributeType::kNames) return;
  // A schema runs once a tick: to list it again can only be a slip.
  const bool once = spec.refers_to == "perceptual_schema" || spec.refers_to == "motor_schema";
  std::unordered_set<std::string_view> seen;
  for (const auto& name : attribute.values) {
    symbols_.check_reference(spec, name, owner, text_is_whole_, diagnostics_);
    if (once && !seen.insert(name.text).second)
      diagnostics_.error(
          name.at, "name/listed-twice",
          in_quotes(name.text) + " stands twice in " + in_quotes(spec.name) + " of " + owner);
  }
}

void AttributeReader::refuse_unknown(const ComponentSpec& spec, const Word& name) const {
  const auto names = spec.attributes | std::views::transform(&AttributeSpec::name);
  std::string hint = did_you_mean(nearest(name.text, names));
  if (hint.empty()) {
    hint = spec.name + " takes";
    for (std::size_t i = 0; i < spec.attributes.size(); ++i)
      hint += (i == 0 ? " " : ", ") + spec.attributes[i].name;
    if (spec.attributes.empty()) hint += " no attributes";
  }
  diagnostics_.error(name.at, "name/unknown-attribute",
                     spec.name + " has no attribute " + in_quotes(name.text), std::move(hint));
}

void AttributeReader::refuse_missing(const AttributeSpec& spec, const Word& type,
                                     const std::string& owner) const {
  if (!text_is_whole_) return;
  diagnostics_.error(
      type.at, "name/missing-attribute",
      owner + " lacks the attribute " + in_quotes(spec.name) + ": " + expectation(spec));
}

void AttributeReader::warn_of_alias(const AttributeSpec& spec, const Word& name) const {
  diagnostics_.warning(name.at, "name/misspelt-attribute",
                       in_quotes(name.text) + " is an old spelling of " + in_quotes(spec.name),
                       "write " + in_quotes(spec.name));
}

}  // namespace galilean::bhdl
