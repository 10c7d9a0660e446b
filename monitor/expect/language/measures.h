// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// How a measure is written, and what it is in.
struct MeasureSpec {
  enum class Of { kRobot, kVariable, kScore };
  std::string_view name;  ///< one word or two
  Measure measure;
  Unit unit;  ///< SI
  Of of;
};

[[nodiscard]] std::span<const MeasureSpec> measure_specs() noexcept;
/// Returns the measure that is written so, or nullptr. Requires: it is not kField.
[[nodiscard]] const MeasureSpec* find_measure(std::string_view name, bool of_variable) noexcept;
[[nodiscard]] const MeasureSpec& spec_of(Measure measure) noexcept;

/// Returns the unit that a field of a message is in, by the end of its name: `_m` is metres. It is
/// no unit if the name ends otherwise.
[[nodiscard]] Unit unit_of_field(std::string_view field) noexcept;

/// Returns the unit of this symbol. Besides those of BHDL it is `%`, a hundredth.
[[nodiscard]] std::optional<Unit> find_expectation_unit(std::string_view symbol) noexcept;
/// Returns the symbol that a word such as "seconds" must mean, or an empty text.
[[nodiscard]] std::string_view meant_unit(std::string_view word);

}  // namespace galilean::expect
