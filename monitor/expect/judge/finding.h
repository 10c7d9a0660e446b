// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "monitor/expect/judge/span_list.h"

namespace galilean::expect {

enum class Outcome { kHolds, kFails, kCannotTell };

/// One place where a claim does not hold.
struct Counterexample {
  std::int64_t at_ns = 0;
  std::string values;  ///< what was so then
  /// The time in which nothing may be missing for it to count: something did not happen in it.
  /// Nothing: what was heard is enough.
  std::optional<Span> needs;
};

/// What a monitor found about a claim for one robot.
struct Finding {
  static constexpr std::size_t kMostKept = 8;

  Outcome outcome = Outcome::kCannotTell;
  std::vector<Counterexample> counterexamples;  ///< the first
  std::uint64_t failures = 0;                   ///< including those that are not kept
  /// Of kHolds: the time in which nothing may be missing for it to count.
  std::optional<Span> needs;
  /// How near the claim was to failing, or by how much it failed if it is negative. Its unit is the
  /// claim's.
  std::optional<double> margin;
  std::string reason;  ///< of kCannotTell: what is missing
  std::string note;    ///< what people should know though it holds
};

/// Lifts the limits of what the finding needs where they are those of `all`, the time in which
/// something was heard: see without_limits_of.
inline void lift_limits(const Span& all, Finding& finding) noexcept {
  if (finding.needs) finding.needs = without_limits_of(all, *finding.needs);
  for (auto& each : finding.counterexamples)
    if (each.needs) each.needs = without_limits_of(all, *each.needs);
}

/// Turns an outcome that rests on a time of which something is missing into "cannot tell".
inline void doubt_where(const SpanList& missing, const std::string& reason, Finding& finding) {
  const auto is_doubtful = [&](const std::optional<Span>& needs) {
    return needs && missing.overlap(*needs);
  };
  if (finding.outcome == Outcome::kFails)
    std::erase_if(finding.counterexamples,
                  [&](const Counterexample& each) { return is_doubtful(each.needs); });
  const bool doubtful = finding.outcome == Outcome::kFails   ? finding.counterexamples.empty()
                        : finding.outcome == Outcome::kHolds ? is_doubtful(finding.needs)
                                                             : false;
  if (!doubtful) return;
  finding.outcome = Outcome::kCannotTell;
  finding.reason = reason;
}

}  // namespace galilean::expect
