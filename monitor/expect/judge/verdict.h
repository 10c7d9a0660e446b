// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/catalog/unit.h"
#include "monitor/expect/judge/finding.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// What came of one claim, for the team or for one robot. `some robot` has one for all its claims.
struct Verdict {
  std::string about;  ///< "io", "team", "some robot", or "every robot" if none was heard
  std::string robot;  ///< whose counterexamples they are; empty if no robot's
  std::string text;   ///< the claim as written
  bhdl::Location at;  ///< where it is written
  Finding finding;
  Unit unit;  ///< of the margin
};

/// What came of all expectations.
struct Judgement {
  std::vector<Verdict> verdicts;          ///< in the order of the file, then of robots' names
  std::int64_t begin_ns = 0, end_ns = 0;  ///< since the Unix epoch
  std::vector<std::string> notes;         ///< sentences on the recording as a whole
  /// Times without a message that a replay passes over. They are no part of the recording's time.
  std::vector<Span> silences;

  [[nodiscard]] std::size_t count(Outcome outcome) const noexcept;
};

/// Returns the unit of a claim's margin, or nothing if it has none.
[[nodiscard]] std::optional<Unit> margin_unit(const Claim& claim);

}  // namespace galilean::expect
