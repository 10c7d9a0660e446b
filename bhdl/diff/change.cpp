// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/diff/change.h"

#include <array>
#include <nlohmann/json.hpp>

#include "bhdl/program/value_words.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

using What = Change::What;

std::string sign(Change::Kind kind) {
  constexpr std::array<std::string_view, 4> kSigns{"+ ", "- ", "~ ", "~ "};
  return std::string(kSigns[static_cast<std::size_t>(kind)]);
}

std::string subject(const Change& change) {
  std::string text(to_string(change.what));
  for (char& c : text) c = c == '_' ? ' ' : c;
  switch (change.what) {
    case What::kStartState:
      return "start_state";
    case What::kOnSwap:
      return "on_swap " + in_quotes(change.name);
    case What::kTransition:
      return "transition from " + in_quotes(change.name) + " when " + change.transition;
    case What::kDevice:
      return text + " " + change.name;
    default:
      return text + (change.type.empty() ? "" : " " + change.type) + " " + in_quotes(change.name);
  }
}

std::string side(const std::optional<Value>& value, const Unit& unit) {
  const std::string words = value ? value_in_words(*value, unit) : std::string();
  return words.empty() ? "nothing" : words;
}

std::string list_in_words(const Change& change) {
  const std::string list = " its " + change.attribute;
  switch (change.kind) {
    case Change::Kind::kAdded:
      return " has " + side(change.to, change.unit) + " among" + list;
    case Change::Kind::kRemoved:
      return " has " + side(change.from, change.unit) + " no longer among" + list;
    default:
      return " has" + list + " in another order: was " + side(change.from, change.unit) + ", is " +
             side(change.to, change.unit);
  }
}

std::string attribute_in_words(const Change& change) {
  std::string text = change.attribute;
  if (!change.entry.empty()) text += " of " + in_quotes(change.entry);
  return text + " was " + side(change.from, change.unit) + ", is " + side(change.to, change.unit);
}

struct ToJson {
  nlohmann::json operator()(const Vec2& pair) const { return {pair.x(), pair.y()}; }
  template <class Other>
  nlohmann::json operator()(const Other& value) const {
    return value;
  }
};

void set(nlohmann::json& json, const char* key, std::string_view text) {
  if (!text.empty()) json[key] = text;
}

}  // namespace

std::string_view to_string(Change::Kind kind) noexcept {
  constexpr std::array<std::string_view, 4> kWords{"added", "removed", "changed", "reordered"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string_view to_string(Change::What what) noexcept {
  constexpr std::array<std::string_view, 8> kWords{"start_state",       "state",       "transition",
                                                   "on_swap",           "device",      "variable",
                                                   "perceptual_schema", "motor_schema"};
  return kWords[static_cast<std::size_t>(what)];
}

std::string in_words(const Change& change) {
  std::string text = sign(change.kind) + subject(change);
  if (change.what == What::kState && !change.attribute.empty()) return text + list_in_words(change);
  if (!change.attribute.empty()) return text + ": " + attribute_in_words(change);
  if (change.kind == Change::Kind::kChanged)
    return text + " was " + side(change.from, change.unit) + ", is " + side(change.to, change.unit);
  const auto& goes_to = change.to ? change.to : change.from;
  return goes_to ? text + " to " + side(goes_to, change.unit) : text;
}

void to_json(nlohmann::json& json, const Change& change) {
  json = {{"kind", to_string(change.kind)}, {"what", to_string(change.what)}};
  set(json, "name", change.name);
  set(json, "type", change.type);
  set(json, "transition", change.transition);
  set(json, "attribute", change.attribute);
  set(json, "entry", change.entry);
  set(json, "unit", change.unit.symbol);
  if (change.from) json["from"] = std::visit(ToJson{}, *change.from);
  if (change.to) json["to"] = std::visit(ToJson{}, *change.to);
}

}  // namespace galilean::bhdl
