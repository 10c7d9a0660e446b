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

/// What a bit may be, as a set. An invalid variable still holds its bits: what writes another of
/// them makes them valid again.
using BitValues = std::uint8_t;
inline constexpr BitValues kBitZero = 1;
inline constexpr BitValues kBitOne = 2;
inline constexpr BitValues kBitInvalid = 4 | 8;  ///< invalid 0, invalid 1

/// The one value that a condition asks for.
[[nodiscard]] constexpr BitValues bit_values_of(bool value) noexcept {
  return value ? kBitOne : kBitZero;
}

/// A bit that a condition tests.
struct TestedBit {
  std::string_view variable;
  unsigned index = 0;

  auto operator<=>(const TestedBit&) const = default;  // NOLINT(modernize-use-nullptr): none here
};

/// Which bits of a variable may be written in each state, and whether it fades when it is not.
struct VariableWriters {
  std::vector<std::uint32_t> in_state;
  bool fades = false;
};

/// The same for variables that conditions test, counted as in Program::variables.
using WritersOfTested = std::unordered_map<std::size_t, VariableWriters>;
[[nodiscard]] WritersOfTested writers_of_tested(const Program& program, const SchemaUses& uses,
                                                std::span<const std::size_t> tested);

/// Follows one bit from state to state: a schema that writes it can make it 0 or 1, a
/// condition that fires has seen the value that it asks for, `bit_update` and `reset_variables`
/// change it, and what is written fades. What this allows may still never happen; what it forbids
/// never does.
class BitFlow {
 public:
  BitFlow(const Program& program, const StateGraph& graph, const VariableWriters& writers,
          const TestedBit& bit);

  /// When a state's conditions are tried; empty if nothing that this bit allows leads there.
  [[nodiscard]] BitValues within(std::size_t state) const noexcept;

 private:
  [[nodiscard]] BitValues initial() const;
  /// Whether anything in the program does: then a program before it may have left the bit so, too.
  [[nodiscard]] bool changes() const;
  /// Empty if the condition cannot fire.
  [[nodiscard]] BitValues behind(const Condition& condition, BitValues values) const;
  void enter(std::size_t state, BitValues values);

  const Program& program_;
  const VariableWriters& writers_;
  const TestedBit& bit_;
  std::vector<BitValues> entered_;
  std::vector<std::size_t> to_visit_;
};

}  // namespace galilean::bhdl
