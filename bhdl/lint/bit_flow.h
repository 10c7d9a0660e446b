// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/lint/schema_use.h"
#include "bhdl/lint/state_graph.h"

namespace galilean::bhdl {

/// The values that a bit may have, as a set. An invalid variable still holds its bits. A write to
/// another of its bits makes them valid again.
using BitValues = std::uint8_t;
inline constexpr BitValues kBitZero = 1;
inline constexpr BitValues kBitOne = 2;
inline constexpr BitValues kBitInvalid = 4 | 8;  ///< invalid 0, invalid 1

/// Returns the one value that a condition tests for.
[[nodiscard]] constexpr BitValues bit_values_of(bool value) noexcept {
  return value ? kBitOne : kBitZero;
}

/// A bit that a condition tests.
struct TestedBit {
  std::string_view variable;
  unsigned index = 0;

  auto operator<=>(const TestedBit&) const = default;  // NOLINT(modernize-use-nullptr): none here
};

/// The bits of a variable that may be written in each state, and whether its certainty fades when
/// nothing writes it.
struct VariableWriters {
  std::vector<std::uint32_t> in_state;
  bool fades = false;
};

/// The writers of the variables that conditions test. The key counts as in Program::variables.
using WritersOfTested = std::unordered_map<std::size_t, VariableWriters>;
[[nodiscard]] WritersOfTested writers_of_tested(const Program& program, const SchemaUses& uses,
                                                std::span<const std::size_t> tested);

/// Follows one bit from state to state. A schema that writes it can make it 0 or 1. A condition
/// that fires has seen the value that it tests for. `bit_update` and `reset_variables` change the
/// bit, and what is written fades. A value that this allows may still never happen. A value that it
/// excludes never happens.
class BitFlow {
 public:
  BitFlow(const Program& program, const StateGraph& graph, const VariableWriters& writers,
          const TestedBit& bit);

  /// Returns the values that the bit may have when the state's conditions are tried. The set is
  /// empty if this bit lets nothing lead there.
  [[nodiscard]] BitValues within(std::size_t state) const noexcept;

 private:
  [[nodiscard]] BitValues initial() const;
  /// Returns whether anything in the program changes the bit. If so, an earlier program may have
  /// changed it, too.
  [[nodiscard]] bool changes() const;
  /// Returns the values behind the condition. The set is empty if the condition cannot fire.
  [[nodiscard]] BitValues behind(const Condition& condition, BitValues values) const;
  void enter(std::size_t state, BitValues values);

  const Program& program_;
  const VariableWriters& writers_;
  const TestedBit& bit_;
  std::vector<BitValues> entered_;
  std::vector<std::size_t> to_visit_;
};

}  // namespace galilean::bhdl
