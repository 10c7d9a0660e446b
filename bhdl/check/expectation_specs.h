// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// The longest time that an expectation may last: an hour of the program's time.
inline constexpr double kLongestExpectation_s = 3600;

/// Returns what `expect:` takes besides its steps. It is declared as state_spec is.
[[nodiscard]] const ComponentSpec& expect_spec();
/// Returns the declarations of its steps: given, reaches, stays, never.
[[nodiscard]] std::span<const ComponentSpec> step_specs();
[[nodiscard]] const ComponentSpec& given_spec();

}  // namespace galilean::bhdl
