// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "core/variable/store.h"

namespace galilean::robot {

/// A variable of any of the five types.
using VariableRef = std::variant<Variable<Shaft>*, Variable<Image>*, Variable<Locate>*,
                                 Variable<Bits>*, Variable<Force>*>;

/// Returns nothing if the store has no variable of that name.
[[nodiscard]] inline std::optional<VariableRef> find_variable(VariableStore& variables,
                                                              std::string_view name) noexcept {
  std::optional<VariableRef> found;
  variables.for_each([&](auto& variable) {
    if (!found && variable.name == name) found = &variable;
  });
  return found;
}

inline void reset(VariableRef variable, Time now) noexcept {
  std::visit([now](auto* each) { each->reset(now); }, variable);
}

}  // namespace galilean::robot
