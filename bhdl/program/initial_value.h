// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Returns whether a variable is valid before any schema writes it: its `status` is "valid" and its
/// `certainty` is more than 0. A type that declares no status counts as valid.
[[nodiscard]] bool starts_valid(const Component& variable);

/// Returns the `value` of a bits variable before any schema writes it, or nothing if its type
/// declares none.
[[nodiscard]] std::optional<std::uint32_t> initial_bits(const Component& variable);

}  // namespace galilean::bhdl
