// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/initial_value.h"

namespace galilean::bhdl {

bool starts_valid(const Component& variable) {
  const Value* status = variable.attributes.find("status");
  const Value* certainty = variable.attributes.find("certainty");
  const auto* word = status == nullptr ? nullptr : std::get_if<std::string>(status);
  const auto* sure = certainty == nullptr ? nullptr : std::get_if<double>(certainty);
  return (word == nullptr || *word == "valid") && (sure == nullptr || *sure > 0);
}

std::optional<std::uint32_t> initial_bits(const Component& variable) {
  const Value* value = variable.attributes.find("value");
  const auto* number = value == nullptr ? nullptr : std::get_if<double>(value);
  if (number == nullptr || *number < 0) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

}  // namespace galilean::bhdl
