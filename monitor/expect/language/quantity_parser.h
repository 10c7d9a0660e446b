// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/catalog/unit.h"
#include "monitor/expect/language/expectation.h"
#include "monitor/expect/language/token_reader.h"

namespace galilean::expect {

/// A number with its unit. `si` is in the unit's dimension.
struct Quantity {
  double si = 0;
  Unit unit;
};

/// Reads a number in a unit of the same dimension as `wanted`. `of` names what it is of in
/// messages, such as "a time". Only 0 may stand without a unit where one is wanted.
[[nodiscard]] std::optional<Quantity> parse_quantity(TokenReader& tokens, const Unit& wanted,
                                                     std::string_view of);
/// Reads a time above 0, in seconds.
[[nodiscard]] std::optional<double> parse_time(TokenReader& tokens);
[[nodiscard]] std::optional<Operator> parse_operator(TokenReader& tokens);
/// Reads a whole number from 0.
[[nodiscard]] std::optional<double> parse_count(TokenReader& tokens);
/// Reads a topic without a field.
[[nodiscard]] std::optional<TopicName> parse_topic(TokenReader& tokens, bool of_robot);

}  // namespace galilean::expect
