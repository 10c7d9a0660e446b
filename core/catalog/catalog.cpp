// SPDX-License-Identifier: BSD-3-Clause
#include "core/catalog/catalog.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/json_text.h"

namespace galilean {
namespace {

constexpr std::array<std::string_view, 5> kKinds{"input_device", "output_device", "variable",
                                                 "perceptual_schema", "motor_schema"};
constexpr std::array<std::string_view, 9> kTypes{"flag",   "number",  "integer", "pair", "text",
                                                 "choice", "numbers", "name",    "names"};
constexpr std::array<std::string_view, 4> kAccess{"none", "read", "write", "update"};

template <class E, std::size_t N>
E parse_word(const std::array<std::string_view, N>& words, const std::string& word) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw std::runtime_error("'" + word + "' is not a known kind, type or access");
  return static_cast<E>(found - words.begin());
}

nlohmann::json value_to_json(const Value& value) {
  if (const auto* pair = std::get_if<Vec2>(&value)) return {pair->x(), pair->y()};
  return std::visit(
      [](const auto& plain) -> nlohmann::json {
        if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, Vec2>)
          return {};
        else
          return plain;
      },
      value);
}

Value value_from_json(const nlohmann::json& json, AttributeType type) {
  switch (type) {
    case AttributeType::kFlag:
      return json.get<bool>();
    case AttributeType::kNumber:
    case AttributeType::kInteger:
      return json.get<double>();
    case AttributeType::kPair:
      return Vec2(json.at(0).get<double>(), json.at(1).get<double>());
    case AttributeType::kNumbers:
      return json.get<std::vector<double>>();
    case AttributeType::kNames:
      return json.get<std::vector<std::string>>();
    case AttributeType::kText:
    case AttributeType::kChoice:
    case AttributeType::kName:
      break;
  }
  return json.get<std::string>();
}

nlohmann::json attribute_to_json(const AttributeSpec& spec) {
  nlohmann::json json{{"name", spec.name},
                      {"type", to_string(spec.type)},
                      {"unit", spec.unit.symbol},
                      {"required", spec.required()},
                      {"help", spec.help}};
  if (!spec.aliases.empty()) json["aliases"] = spec.aliases;
  if (spec.default_value) json["default"] = value_to_json(*spec.default_value);
  if (std::isfinite(spec.minimum)) json["minimum"] = spec.minimum;
  if (std::isfinite(spec.maximum)) json["maximum"] = spec.maximum;
  if (spec.count) json["count"] = spec.count;
  if (!spec.choices.empty()) json["choices"] = spec.choices;
  if (!spec.refers_to.empty()) json["refers_to"] = spec.refers_to;
  if (!spec.one_for_each.empty()) json["one_for_each"] = spec.one_for_each;
  if (!spec.bit_of.empty()) json["bit_of"] = spec.bit_of;
  if (!spec.only_with.empty()) json["only_with"] = spec.only_with;
  if (!spec.only_without.empty()) json["only_without"] = spec.only_without;
  if (spec.access != Access::kNone) json["access"] = to_string(spec.access);
  if (spec.role != Role::kNone) json["role"] = to_string(spec.role);
  if (!spec.of.empty()) json["of"] = spec.of;
  return json;
}

AttributeSpec attribute_from_json(const nlohmann::json& json) {
  AttributeSpec spec;
  spec.name = json.at("name");
  spec.type = parse_word<AttributeType>(kTypes, json.at("type"));
  const auto unit = find_unit(json.value("unit", ""));
  if (!unit) throw std::runtime_error("unknown unit '" + json.value("unit", "") + "'");
  spec.unit = *unit;
  spec.aliases = json.value("aliases", spec.aliases);
  if (json.contains("default")) spec.default_value = value_from_json(json["default"], spec.type);
  spec.minimum = json.value("minimum", spec.minimum);
  spec.maximum = json.value("maximum", spec.maximum);
  spec.count = json.value("count", spec.count);
  spec.choices = json.value("choices", spec.choices);
  spec.refers_to = json.value("refers_to", "");
  spec.one_for_each = json.value("one_for_each", "");
  spec.bit_of = json.value("bit_of", "");
  spec.only_with = json.value("only_with", "");
  spec.only_without = json.value("only_without", "");
  spec.access = parse_word<Access>(kAccess, json.value("access", "none"));
  spec.role = role_named(json.value("role", ""));
  spec.of = json.value("of", "");
  spec.help = json.value("help", "");
  return spec;
}

ComponentSpec component_from_json(const nlohmann::json& json) {
  ComponentSpec component;
  component.name = json.at("name");
  component.kind = parse_word<ComponentKind>(kKinds, json.at("kind"));
  component.help = json.value("help", "");
  component.drives = json.value("drives", "");
  component.needs = json.value("needs", component.needs);
  component.configures = json.value("configures", "");
  for (const auto& attribute : json.at("attributes"))
    component.attributes.push_back(attribute_from_json(attribute));
  return component;
}

}  // namespace

std::string_view to_string(ComponentKind kind) noexcept {
  return kKinds[static_cast<int>(kind)];
}
std::string_view to_string(AttributeType type) noexcept {
  return kTypes[static_cast<int>(type)];
}
std::string_view to_string(Access access) noexcept {
  return kAccess[static_cast<int>(access)];
}

const AttributeSpec* ComponentSpec::find(std::string_view attribute) const noexcept {
  for (const auto& spec : attributes)
    if (spec.name == attribute || std::ranges::find(spec.aliases, attribute) != spec.aliases.end())
      return &spec;
  return nullptr;
}

const AttributeSpec* ComponentSpec::find(Role role) const noexcept {
  const auto found = std::ranges::find(attributes, role, &AttributeSpec::role);
  return found == attributes.end() ? nullptr : &*found;
}

const ComponentSpec* Catalog::find(std::string_view component) const noexcept {
  for (const auto& spec : components)
    if (spec.name == component) return &spec;
  return nullptr;
}

void to_json(nlohmann::json& json, const Catalog& catalog) {
  json = {{"components", nlohmann::json::array()}};
  for (const auto& component : catalog.components) {
    nlohmann::json attributes = nlohmann::json::array();
    for (const auto& attribute : component.attributes)
      attributes.push_back(attribute_to_json(attribute));
    json["components"].push_back({{"name", component.name},
                                  {"kind", to_string(component.kind)},
                                  {"help", component.help},
                                  {"attributes", attributes}});
    nlohmann::json& entry = json["components"].back();
    if (!component.drives.empty()) entry["drives"] = component.drives;
    if (!component.needs.empty()) entry["needs"] = component.needs;
    if (!component.configures.empty()) entry["configures"] = component.configures;
  }
}

std::string catalog_to_json(const Catalog& catalog) {
  return json_text(nlohmann::json(catalog), 1);
}

Result<Catalog> catalog_from_json(std::string_view text) {
  std::string where = "the catalog";
  try {
    Catalog catalog;
    const auto json = read_json(text);
    if (!json) return Error{where + " cannot be read: " + json.error().message};
    for (const auto& component : json.value().at("components")) {
      where = "component '" + component.value("name", "?") + "' of the catalog";
      catalog.components.push_back(component_from_json(component));
    }
    return catalog;
  } catch (const std::exception& problem) {
    return Error{where + " cannot be read: " + problem.what()};
  }
}

}  // namespace galilean
