#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace galilean::monitor {

/// A request that does not say what it must; what() tells its author.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The members of a request; those that are left out have the default. Throw BadRequest where one
/// has the wrong type.
[[nodiscard]] inline std::string text_field(const nlohmann::json& request, const char* name,
                                            std::string absent = {}) {
  if (!request.contains(name)) return absent;
  if (!request[name].is_string()) throw BadRequest("'" + std::string(name) + "' must be a string.");
  return request[name];
}

[[nodiscard]] inline int whole_number_field(const nlohmann::json& request, const char* name,
                                            int absent) {
  if (!request.contains(name)) return absent;
  if (!request[name].is_number_integer())
    throw BadRequest("'" + std::string(name) + "' must be a whole number.");
  return request[name];
}

[[nodiscard]] inline double number_field(const nlohmann::json& request, const char* name,
                                         double absent, double least, double most) {
  if (!request.contains(name)) return absent;
  const bool fits = request[name].is_number() && request[name].get<double>() >= least &&
                    request[name].get<double>() <= most;
  if (!fits)
    throw BadRequest("'" + std::string(name) + "' must be a number from " +
                     nlohmann::json(least).dump() + " to " + nlohmann::json(most).dump() + ".");
  return request[name];
}

[[nodiscard]] inline bool flag_field(const nlohmann::json& request, const char* name) {
  if (!request.contains(name)) return false;
  if (!request[name].is_boolean())
    throw BadRequest("'" + std::string(name) + "' must be true or false.");
  return request[name];
}

[[nodiscard]] inline std::vector<std::string> names_field(const nlohmann::json& request,
                                                          const char* name) {
  std::vector<std::string> names;
  if (!request.contains(name)) return names;
  const auto wrong = "'" + std::string(name) + "' must be a list of strings.";
  if (!request[name].is_array()) throw BadRequest(wrong);
  for (const auto& item : request[name]) {
    if (!item.is_string()) throw BadRequest(wrong);
    names.push_back(item);
  }
  return names;
}

}  // namespace galilean::monitor
