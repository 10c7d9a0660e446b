// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/json_reader.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/visible_text.h"

namespace galilean::sim {
namespace {

using nlohmann::json;

const json kEmptyObject = json::object();

std::string shown(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string shown(const json& value) {
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  return text;
}

}  // namespace

JsonReader::JsonReader(const json& source, std::string path)
    : json_(&source), path_(std::move(path)) {
  if (!json_->is_object())
    throw JsonError((path_.empty() ? "the file" : path_) + ": expected an object {…}, found " +
                    shown(*json_));
}

std::string JsonReader::path_of(std::string_view field) const {
  return path_.empty() ? std::string(field) : path_ + "." + std::string(field);
}

bool JsonReader::has(std::string_view field) const {
  return json_->contains(std::string(field));
}

const json* JsonReader::take(std::string_view field) {
  known_.emplace_back(field);
  const auto found = json_->find(std::string(field));
  return found == json_->end() ? nullptr : &*found;
}

const json& JsonReader::need(std::string_view field, std::string_view expected) {
  const json* value = take(field);
  if (!value) throw JsonError(path_of(field) + ": missing; expected " + std::string(expected));
  return *value;
}

double JsonReader::checked(const json& value, std::string_view field, double minimum,
                           double maximum) const {
  const bool fits = value.is_number() && std::isfinite(value.get<double>()) &&
                    value.get<double>() >= minimum && value.get<double>() <= maximum;
  if (!fits)
    throw JsonError(path_of(field) + ": expected a number from " + shown(minimum) + " to " +
                    shown(maximum) + ", found " + shown(value));
  return value.get<double>();
}

double JsonReader::number(std::string_view field, double minimum, double maximum) {
  return checked(need(field, "a number"), field, minimum, maximum);
}

double JsonReader::number_or(std::string_view field, double preset, double minimum,
                             double maximum) {
  const json* value = take(field);
  return value ? checked(*value, field, minimum, maximum) : preset;
}

int JsonReader::integer_or(std::string_view field, int preset, int minimum, int maximum) {
  const json* value = take(field);
  if (!value) return preset;
  if (!value->is_number_integer())
    throw JsonError(path_of(field) + ": expected a whole number, found " + shown(*value));
  return static_cast<int>(checked(*value, field, minimum, maximum));
}

std::string JsonReader::text(std::string_view field) {
  const json& value = need(field, "text");
  if (!value.is_string())
    throw JsonError(path_of(field) + ": expected text, found " + shown(value));
  return value.get<std::string>();
}

bool JsonReader::flag(std::string_view field) {
  const json& value = need(field, "true or false");
  if (!value.is_boolean())
    throw JsonError(path_of(field) + ": expected true or false, found " + shown(value));
  return value.get<bool>();
}

std::vector<double> JsonReader::numbers(std::string_view field) {
  const json& value = need(field, "a list of numbers");
  const bool fits =
      value.is_array() && std::all_of(value.begin(), value.end(), [](const json& one) {
        return one.is_number() && std::isfinite(one.get<double>());
      });
  if (!fits)
    throw JsonError(path_of(field) + ": expected a list of numbers, found " + shown(value));
  return value.get<std::vector<double>>();
}

Vec2 JsonReader::pair(std::string_view field) {
  const json& value = need(field, "a pair [x, y]");
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
    throw JsonError(path_of(field) + ": expected a pair [x, y], found " + shown(value));
  constexpr double kFarthest = 1000;
  return {checked(value[0], field, -kFarthest, kFarthest),
          checked(value[1], field, -kFarthest, kFarthest)};
}

Vec2 JsonReader::pair_or(std::string_view field, const Vec2& preset) {
  if (has(field)) return pair(field);
  known_.emplace_back(field);
  return preset;
}

JsonReader JsonReader::object(std::string_view field) {
  const json* value = take(field);
  return {value ? *value : kEmptyObject, path_of(field)};
}

std::vector<JsonReader> JsonReader::list(std::string_view field) {
  std::vector<JsonReader> items;
  const json* value = take(field);
  if (!value) return items;
  if (!value->is_array())
    throw JsonError(path_of(field) + ": expected a list […], found " + shown(*value));
  for (std::size_t i = 0; i < value->size(); ++i)
    items.emplace_back((*value)[i], path_of(field) + "[" + std::to_string(i) + "]");
  return items;
}

void JsonReader::finish() const {
  for (const auto& [field, value] : json_->items()) {
    if (std::find(known_.begin(), known_.end(), field) != known_.end()) continue;
    std::string expected;
    for (const auto& name : known_) expected += (expected.empty() ? "" : ", ") + name;
    throw JsonError(path_of(visible(field)) + ": unknown field; expected one of " + expected);
  }
}

}  // namespace galilean::sim
