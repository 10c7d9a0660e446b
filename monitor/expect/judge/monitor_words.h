// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/expect/judge/duration_text.h"
#include "monitor/expect/judge/finding.h"

namespace galilean::expect {

[[nodiscard]] inline double seconds(std::int64_t duration_ns) {
  return static_cast<double>(duration_ns) * 1e-9;
}

inline void cannot_tell(Finding& finding, std::string reason) {
  finding.outcome = Outcome::kCannotTell;
  finding.reason = std::move(reason);
}

/// Says that the recording ends before a deadline.
inline void too_short(Finding& finding, std::int64_t missing_ns) {
  cannot_tell(finding, "the recording ends " + duration_text(missing_ns) + " too early to tell");
}

}  // namespace galilean::expect
