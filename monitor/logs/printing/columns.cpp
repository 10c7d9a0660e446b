// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/printing/columns.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/json_text.h"

namespace galilean::logs {
namespace {

/// JSON has no word for what is no number.
std::string number_text(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

}  // namespace

void for_each_value(
    const monitor::MessageTree& message, const std::string& prefix,
    const std::function<void(const std::string&, const monitor::MessageTree&)>& take) {
  if (message.is_object()) {
    for (const auto& [name, field] : message.items())
      for_each_value(field, prefix.empty() ? name : prefix + "." + name, take);
  } else if (message.is_array()) {
    for (std::size_t i = 0; i < message.size(); ++i)
      for_each_value(message[i], prefix + "[" + std::to_string(i) + "]", take);
  } else {
    take(prefix, message);
  }
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string csv_cell(const monitor::MessageTree& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return csv_text(value.get_ref<const std::string&>());
  if (value.is_number_float()) return number_text(value.get<double>());
  return ordered_json_text(value);
}

Result<void> Columns::add(const monitor::MessageTree& message, const std::string& prefix) {
  std::size_t place = 0;  // behind the column of the value before
  bool full = false;
  for_each_value(message, prefix, [&](const std::string& name, const monitor::MessageTree&) {
    if (full) return;
    const auto found = places_.find(name);
    if (found == places_.end() && names_.size() == kMost) {
      full = true;
      return;
    }
    if (found == places_.end()) insert(place, name);
    place = places_.at(name) + 1;
  });
  if (full)
    return Error{"the messages have more than " + std::to_string(kMost) +
                 " values each; choose some with --field"};
  return {};
}

void Columns::insert(std::size_t place, const std::string& name) {
  names_.insert(names_.begin() + static_cast<std::ptrdiff_t>(place), name);
  for (std::size_t at = place; at < names_.size(); ++at) places_[names_[at]] = at;
}

}  // namespace galilean::logs
