// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/attribute_reader.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "bhdl/check/value_reader.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

bool takes_numbers(AttributeType type) noexcept {
  return type == AttributeType::kNumber || type == AttributeType::kInteger ||
         type == AttributeType::kNumbers || type == AttributeType::kPair;
}

bool names_something(const AttributeValues& values, std::string_view attribute) {
  const Value* value = values.find(attribute);
  const auto* name = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return name != nullptr && !name->empty();
}

std::optional<std::size_t> list_size(const Value* value) {
  if (value == nullptr) return std::nullopt;
  if (const auto* numbers = std::get_if<std::vector<double>>(value)) return numbers->size();
  if (const auto* names = std::get_if<std::vector<std::string>>(value)) return names->size();
  return std::nullopt;
}

Hint attribute_hint(const ComponentSpec& spec, std::string_view misspelt) {
  const std::string near = nearest(misspelt, names_of(spec.attributes));
  if (!near.empty()) return did_you_mean(near);
  if (spec.attributes.empty()) return spec.name + " takes no attributes";
  std::string hint = spec.name + " takes";
  for (std::size_t i = 0; i < spec.attributes.size(); ++i)
    hint += (i == 0 ? " " : ", ") + spec.attributes[i].name;
  return hint;
}

}  // namespace

AttributeValues AttributeReader::read(const ComponentSpec& spec, const Word& type,
                                      const std::vector<AttributeNode>& attributes) const {
  const AttributeContext context{type, attributes};
  std::vector<const AttributeNode*> given(spec.attributes.size(), nullptr);
  AttributeValues values;
  values.reserve(spec.attributes.size());
  Diagnostics reported_at_base;
  const AttributeReader at_base(symbols_, text_is_whole_, reported_at_base);
  for (const auto& attribute : attributes) {
    const AttributeSpec* known = spec.find(attribute.name.text);
    const AttributeReader& reader = attribute.inherited ? at_base : *this;
    if (known == nullptr) {
      reader.refuse_unknown(spec, attribute.name);
      continue;
    }
    const AttributeNode*& first = given[static_cast<std::size_t>(known - spec.attributes.data())];
    if (first != nullptr)
      refuse_second(*known, attribute.name, first->name, context);
    else
      reader.read_one(attribute, *known, context, values);
    first = &attribute;
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i] == nullptr) fill_in(spec.attributes[i], type, context, values);
  check_matching_counts(spec, type, context, values);
  warn_of_unread(spec, given, context, values);
  return values;
}

void AttributeReader::read_one(const AttributeNode& attribute, const AttributeSpec& spec,
                               const AttributeContext& context, AttributeValues& values) const {
  if (attribute.name.text != spec.name) warn_of_alias(spec, attribute.name);
  if (!constants_exist(attribute, spec, context)) return;
  auto value = read_value(attribute, spec, context, diagnostics_);
  if (!value) return;
  check_names(attribute, spec, context);
  values.add(spec.name, std::move(*value));
}

// Returns false if a bare word is left, because no constant has its name. It is reported only if
// the whole text was read: the unread part may define the constant.
bool AttributeReader::constants_exist(const AttributeNode& attribute, const AttributeSpec& spec,
                                      const AttributeContext& context) const {
  if (!takes_numbers(spec.type)) return true;
  const auto word =
      std::ranges::find(attribute.values, ValueNode::Kind::kBareWord, &ValueNode::kind);
  if (word == attribute.values.end()) return true;
  if (text_is_whole_) symbols_.refuse_undefined_constant(spec, *word, context, diagnostics_);
  return false;
}

// The name that a default gives must exist like any other. An empty default names nothing.
void AttributeReader::fill_in(const AttributeSpec& spec, const Word& type,
                              const AttributeContext& context, AttributeValues& values) const {
  if (!spec.default_value) return refuse_missing(spec, type, context);
  const auto* name = std::get_if<std::string>(&*spec.default_value);
  if (spec.type == AttributeType::kName && name != nullptr && !name->empty())
    symbols_.check_reference(spec, {ValueNode::Kind::kText, 0, 0, *name, type.at}, context,
                             text_is_whole_, diagnostics_);
  values.add(spec.name, to_si(*spec.default_value, spec.unit));
}

void AttributeReader::check_matching_counts(const ComponentSpec& spec, const Word& type,
                                            const AttributeContext& context,
                                            const AttributeValues& values) const {
  for (const auto& each : spec.attributes) {
    if (each.one_for_each.empty()) continue;
    const auto count = list_size(values.find(each.name));
    const auto expected = list_size(values.find(each.one_for_each));
    if (!count || !expected) continue;
    if (*count == 0 || *count == *expected) continue;
    diagnostics_.error(type.at, "value/count",
                       in_quotes(each.name) + " of " + label(context) + " has " +
                           std::to_string(*count) + " entries, but " +
                           in_quotes(each.one_for_each) + " has " + std::to_string(*expected) +
                           ": give one for each entry of " + in_quotes(each.one_for_each));
  }
}

// Nothing is warned of unless the whole text was read: the unread part may hold the attribute that
// this one belongs to.
void AttributeReader::warn_of_unread(const ComponentSpec& spec,
                                     const std::vector<const AttributeNode*>& given,
                                     const AttributeContext& context,
                                     const AttributeValues& values) const {
  if (!text_is_whole_) return;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const AttributeSpec& each = spec.attributes[i];
    if (given[i] == nullptr || given[i]->inherited) continue;
    const auto warn = [&](const std::string& why, std::string hint) {
      diagnostics_.warning(given[i]->name.at, "value/unread",
                           in_quotes(each.name) + " of " + label(context) + " has no effect" + why,
                           std::move(hint));
    };
    if (!each.only_with.empty() && !names_something(values, each.only_with))
      warn(" without " + in_quotes(each.only_with),
           "give it " + in_quotes(each.only_with) + ", or take this away");
    if (!each.only_without.empty() && names_something(values, each.only_without))
      warn(", because " + label(context) + " has " + in_quotes(each.only_without),
           "take one of the two away");
  }
}

void AttributeReader::check_names(const AttributeNode& attribute, const AttributeSpec& spec,
                                  const AttributeContext& context) const {
  if (spec.type != AttributeType::kName && spec.type != AttributeType::kNames) return;
  // A schema runs once a tick. Listing it again can only be a mistake.
  const bool once = spec.refers_to == "perceptual_schema" || spec.refers_to == "motor_schema";
  std::unordered_set<std::string_view> seen;
  for (const auto& name : attribute.values) {
    symbols_.check_reference(spec, name, context, text_is_whole_, diagnostics_);
    if (once && attribute.values.size() > 1 && !seen.insert(name.text).second)
      diagnostics_.error(name.at, "name/listed-twice",
                         in_quotes(name.text) + " stands twice in " + in_quotes(spec.name) +
                             " of " + label(context));
  }
}

void AttributeReader::refuse_unknown(const ComponentSpec& spec, const Word& name) const {
  Hint hint = diagnostics_.full() ? Hint() : attribute_hint(spec, name.text);
  diagnostics_.error(name.at, "name/unknown-attribute",
                     spec.name + " has no attribute " + in_quotes(name.text), std::move(hint));
}

void AttributeReader::refuse_second(const AttributeSpec& spec, const Word& second,
                                    const Word& first, const AttributeContext& context) const {
  diagnostics_.error(second.at, "name/duplicate-attribute",
                     in_quotes(spec.name) + " of " + label(context) +
                         " is given twice: the other is at " + place(first.at),
                     {}, {{first.at, "the other"}});
}

void AttributeReader::refuse_missing(const AttributeSpec& spec, const Word& type,
                                     const AttributeContext& context) const {
  if (!text_is_whole_) return;
  diagnostics_.error(
      type.at, "name/missing-attribute",
      label(context) + " lacks the attribute " + in_quotes(spec.name) + ": " + expectation(spec));
}

void AttributeReader::warn_of_alias(const AttributeSpec& spec, const Word& name) const {
  diagnostics_.warning(name.at, "name/misspelt-attribute",
                       in_quotes(name.text) + " is an old spelling of " + in_quotes(spec.name),
                       Hint("write " + in_quotes(spec.name), spec.name));
}

}  // namespace galilean::bhdl
