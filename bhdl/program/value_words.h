// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/unit.h"
#include "core/catalog/value.h"

namespace galilean::bhdl {

/// Returns a value as a program would write it: `yes`, `<0, -1>`, `"trash" "basket"`.
[[nodiscard]] std::string value_in_words(const Value& value);
/// The same with the unit's symbol behind it, if it has one: `5 s`.
[[nodiscard]] std::string value_in_words(const Value& value, const Unit& unit);

/// A loaded value in the unit that a program writes it in, rounded to 12 digits, so that what SI
/// cannot hold exactly reads as it was written.
[[nodiscard]] Value from_si(Value value, const Unit& unit);

}  // namespace galilean::bhdl
