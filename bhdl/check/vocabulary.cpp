// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/vocabulary.h"

#include <array>
#include <cmath>

#include "bhdl/check/state_specs.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

std::string with_unit(std::string text, const Unit& unit) {
  if (!unit.symbol.empty()) text.append(" ").append(unit.symbol);
  return text;
}

std::string in_unit(std::string text, const Unit& unit) {
  if (!unit.symbol.empty()) text.append(" in ").append(unit.symbol);
  return text;
}

std::string choices_in_words(const std::vector<std::string>& choices) {
  std::string text = "one of";
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += (i == 0 ? " " : ", ") + ("\"" + choices[i] + "\"");
  return text;
}

std::string target_in_words(const std::string& refers_to) {
  if (refers_to.empty()) return "something";
  if (refers_to == "variable") return "a variable";
  if (refers_to == "state") return "a state";
  if (refers_to == "perceptual_schema") return "a perceptual schema";
  if (refers_to == "motor_schema") return "a motor schema";
  return "a " + refers_to + " variable";
}

std::string counted(const AttributeSpec& spec, const std::string& what) {
  if (!spec.one_for_each.empty()) return what + ", one for each of " + spec.one_for_each;
  return spec.count == 0 ? "a list of " + what : std::to_string(spec.count) + " " + what;
}

}  // namespace

Vocabulary::Vocabulary(const Catalog& catalog) : components_(catalog.components) {
  for (auto& component : components_) {
    if (!is_device(component.kind) && component.find(name_spec().name) == nullptr)
      component.attributes.insert(component.attributes.begin(), name_spec());
    by_name_.emplace(component.name, &component);
  }
}

const ComponentSpec* Vocabulary::find(std::string_view component) const noexcept {
  const auto found = by_name_.find(component);
  return found == by_name_.end() ? nullptr : found->second;
}

bool is_device(ComponentKind kind) noexcept {
  return kind == ComponentKind::kInputDevice || kind == ComponentKind::kOutputDevice;
}

std::string_view kind_in_words(ComponentKind kind) noexcept {
  constexpr std::array<std::string_view, 5> kWords{"input device", "output device", "variable",
                                                   "perceptual schema", "motor schema"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string expectation(const AttributeSpec& spec) {
  switch (spec.type) {
    case AttributeType::kFlag:
      return "yes or no (or 1 or 0)";
    case AttributeType::kNumber:
      return in_unit("a number", spec.unit);
    case AttributeType::kInteger:
      return in_unit("a whole number", spec.unit);
    case AttributeType::kPair:
      return in_unit("a pair such as <0, 22>", spec.unit);
    case AttributeType::kText:
      return "a text in quotes";
    case AttributeType::kChoice:
      return choices_in_words(spec.choices);
    case AttributeType::kNumbers:
      return in_unit(counted(spec, "numbers"), spec.unit);
    case AttributeType::kName:
      return "the name of " + target_in_words(spec.refers_to) + " in quotes";
    case AttributeType::kNames:
      return counted(spec, "names in quotes, each of ") + target_in_words(spec.refers_to);
  }
  return {};
}

std::string range_in_words(const AttributeSpec& spec) {
  const bool least = std::isfinite(spec.minimum);
  const bool most = std::isfinite(spec.maximum);
  if (least && most)
    return with_unit(number_text(spec.minimum) + " to " + number_text(spec.maximum), spec.unit);
  if (least) return with_unit("at least " + number_text(spec.minimum), spec.unit);
  if (most) return with_unit("at most " + number_text(spec.maximum), spec.unit);
  return {};
}

}  // namespace galilean::bhdl
