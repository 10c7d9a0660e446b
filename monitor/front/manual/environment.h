// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "monitor/front/manual/described_verbs.h"

namespace galilean::front {

/// A variable of the environment that programs read.
struct EnvironmentVariable {
  std::string_view name;
  std::string_view meaning;
  std::string_view options;  ///< verbs with one of these read it; commas between them
  std::string_view verbs;    ///< these read it, too; commas between them
};

/// Returns all variables that the programs read.
[[nodiscard]] std::span<const EnvironmentVariable> environment_variables() noexcept;
/// Returns the variables that this verb's program reads.
[[nodiscard]] std::vector<EnvironmentVariable> environment_of(const DescribedVerb& verb);

}  // namespace galilean::front
