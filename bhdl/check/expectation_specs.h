// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// The longest that an expectation may last: an hour of the program's time.
inline constexpr double kLongestExpectation_s = 3600;

/// What `expect:` takes besides its steps, declared as state_spec is.
[[nodiscard]] const ComponentSpec& expect_spec();
/// Its steps: given, reaches, stays, never.
[[nodiscard]] std::span<const ComponentSpec> step_specs();
[[nodiscard]] const ComponentSpec& given_spec();

}  // namespace galilean::bhdl
