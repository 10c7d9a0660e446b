// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/program.h"

#include <algorithm>
#include <array>

namespace galilean::bhdl {

std::string_view to_string(BitUpdate update) noexcept {
  constexpr std::array<std::string_view, 4> kWords{"same", "set", "clear", "toggle"};
  return kWords[static_cast<std::size_t>(update)];
}

const State* Program::find_state(std::string_view state) const noexcept {
  const auto found = std::ranges::find(states, state, &State::name);
  return found == states.end() ? nullptr : &*found;
}

}  // namespace galilean::bhdl
