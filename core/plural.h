// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace galilean {

/// Returns a count with its noun, such as "1 state" and "2 states".
/// Requires: the noun's plural is made with an s alone.
template <std::integral Number>
[[nodiscard]] std::string plural(Number count, std::string_view noun) {
  std::string text = std::to_string(count) + ' ';
  text += noun;
  if (count != 1) text += 's';
  return text;
}

/// Returns the form of a verb, or of another word, that goes with so many: `one` with 1, else
/// `many`.
template <std::integral Number>
[[nodiscard]] constexpr const char* agreeing(Number count, const char* one,
                                             const char* many) noexcept {
  return count == 1 ? one : many;
}

}  // namespace galilean
