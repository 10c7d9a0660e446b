// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/expect/judge/verdict.h"
#include "monitor/expect/problems/problems.h"

namespace galilean::expect {

/// A judgement and what it is about.
struct Report {
  std::string recording;  ///< its path, as it was given; what was heard, if it was live
  const Judgement& judgement;
  bool live = false;  ///< it is about a team that was heard, and which no recording shows again
  std::vector<Problem> problems = {};  ///< what went wrong in the run, beside the expectations
};

// Each returns the whole report in one form, with a line end.

/// For people: what fails with its place, values and how to see it.
[[nodiscard]] std::string text_report(const Report& report);
/// JUnit's XML, as CI servers read it. What cannot be told is an error, and no success.
[[nodiscard]] std::string junit_report(const Report& report);
/// TAP version 13.
[[nodiscard]] std::string tap_report(const Report& report);
[[nodiscard]] std::string json_report(const Report& report);
/// Workflow commands of GitHub Actions, which annotate the lines of the expectations.
[[nodiscard]] std::string github_report(const Report& report);

}  // namespace galilean::expect
