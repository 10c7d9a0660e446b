// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/unit.h"
#include "core/catalog/value.h"

namespace galilean::bhdl {

/// Returns a value as a program would write it: `yes`, `<0, -1>`, `"trash" "basket"`.
[[nodiscard]] std::string value_in_words(const Value& value);
/// Returns the same with the unit's symbol behind it, if it has one: `5 s`.
[[nodiscard]] std::string value_in_words(const Value& value, const Unit& unit);

/// Returns a loaded value in the unit in which a program writes it. It is rounded to 12 digits, so
/// that a value that SI cannot hold exactly reads as it was written.
[[nodiscard]] Value from_si(Value value, const Unit& unit);

}  // namespace galilean::bhdl
