// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace galilean::msg {

/// A constant of the IDL by its name in lower case, such as {"stop_team", 2}. Each group of
/// constants has all of its own as `kAll`, in the order of the IDL.
struct NamedConstant {
  std::string_view name;
  std::uint8_t value;
};
using NamedConstants = std::span<const NamedConstant>;

/// Returns the name of the constant with this value. Returns the value in digits if there is none,
/// because the message may be of a later release.
[[nodiscard]] inline std::string name_of(NamedConstants constants, std::uint8_t value) {
  const auto found = std::ranges::find(constants, value, &NamedConstant::value);
  return found == constants.end() ? std::to_string(value) : std::string(found->name);
}

/// Returns the value of the constant with this name, or nothing if there is none.
[[nodiscard]] inline std::optional<std::uint8_t> value_of(NamedConstants constants,
                                                          std::string_view name) noexcept {
  const auto found = std::ranges::find(constants, name, &NamedConstant::name);
  if (found == constants.end()) return std::nullopt;
  return found->value;
}

/// Returns the names as "stop, stop_team or lock".
[[nodiscard]] inline std::string choice_of(NamedConstants constants) {
  std::string list;
  for (const auto& each : constants) {
    const bool is_last = &each == &constants.back();
    list += (list.empty() ? "" : is_last ? " or " : ", ") + std::string(each.name);
  }
  return list;
}

}  // namespace galilean::msg
