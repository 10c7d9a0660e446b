// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/expect/judge/belief.h"
#include "monitor/expect/judge/truth.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// A number, or why there is none: kMissing or kVoid.
struct Reading {
  Truth truth = Truth::kMissing;
  double number = 0;  ///< SI; of kTrue
};

/// Returns the number that a comparison is about.
[[nodiscard]] Reading read_number(const Comparison& comparison, const Belief& belief,
                                  std::int64_t at_ns);

/// A text, or why there is none.
struct NameReading {
  Truth truth = Truth::kMissing;
  std::string_view name;
};
[[nodiscard]] NameReading read_name(const NameIs& condition, const Belief& belief,
                                    std::int64_t at_ns);

/// Returns a variable, or nullptr if it is unknown or was told too long ago.
[[nodiscard]] const KnownVariable* known_variable(const Belief& belief, std::string_view name,
                                                  std::int64_t at_ns);
/// Returns the time since variables were told [s].
[[nodiscard]] double age_s(const Belief& belief, std::int64_t at_ns);

}  // namespace galilean::expect
