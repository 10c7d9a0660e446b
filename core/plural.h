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

}  // namespace galilean
