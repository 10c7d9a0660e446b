// SPDX-License-Identifier: BSD-3-Clause
#include "core/state_change.h"

namespace galilean {

std::string change_words(std::string_view from, std::string_view to) {
  if (from.empty() && to.empty()) return "at any change of state";
  if (from.empty()) return "on entering " + std::string(to);
  if (to.empty()) return "on leaving " + std::string(from);
  return std::string(from) + " -> " + std::string(to);
}

std::string place_words(std::string_view from, std::string_view to) {
  const bool names_both = !from.empty() && !to.empty();
  return (names_both ? "at " : "") + change_words(from, to);
}

}  // namespace galilean
