// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"

namespace galilean::sim {

/// Says which place of a JSON document is wrong, and what belongs there.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads one object of a JSON document field by field. Every error names the path
/// (`arena.width_m`). `finish` also refuses fields that nobody asked for.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& json, std::string path);

  [[nodiscard]] bool has(std::string_view field) const;
  [[nodiscard]] double number(std::string_view field, double minimum, double maximum);
  [[nodiscard]] double number_or(std::string_view field, double preset, double minimum,
                                 double maximum);
  [[nodiscard]] int integer_or(std::string_view field, int preset, int minimum, int maximum);
  [[nodiscard]] bool flag(std::string_view field);
  [[nodiscard]] std::string text(std::string_view field);
  /// Returns a list of finite numbers.
  [[nodiscard]] std::vector<double> numbers(std::string_view field);
  [[nodiscard]] Vec2 pair(std::string_view field);
  [[nodiscard]] Vec2 pair_or(std::string_view field, const Vec2& preset);
  /// Returns a field that holds an object, or an empty object if the field is missing.
  [[nodiscard]] JsonReader object(std::string_view field);
  /// Returns a field that holds a list of objects, or an empty list if the field is missing.
  [[nodiscard]] std::vector<JsonReader> list(std::string_view field);

  /// Refuses fields that were never asked for.
  void finish() const;
  [[nodiscard]] std::string path_of(std::string_view field) const;

 private:
  const nlohmann::json* take(std::string_view field);
  const nlohmann::json& need(std::string_view field, std::string_view expected);
  double checked(const nlohmann::json& value, std::string_view field, double minimum,
                 double maximum) const;

  const nlohmann::json* json_;
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace galilean::sim
