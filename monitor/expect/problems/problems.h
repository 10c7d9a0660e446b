// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::expect {

/// What went wrong beside expectations: a mistake in them, a recording that cannot be read, or a
/// run that came to nothing.
struct Problem {
  std::string message;  ///< one line or several
  std::string file;     ///< where it is; empty: in no file
  int line = 0, column = 0;
  std::string name = "nothing was judged";  ///< what stands for the place of one in no file
};

/// Returns a problem as a case of JUnit's XML. `about` names what is judged.
[[nodiscard]] std::string junit_case(const std::string& about, const Problem& problem);
/// Returns a problem as the test of that number in TAP.
[[nodiscard]] std::string tap_test(std::size_t number, const Problem& problem);

// Each returns a report of errors alone in one form, with a line end, for a judgement that did not
// come about. `about` names what would have been judged. Without a problem nothing is wrong.

/// JUnit's XML.
[[nodiscard]] std::string junit_problems(const std::string& about,
                                         const std::vector<Problem>& problems);
/// TAP version 13.
[[nodiscard]] std::string tap_problems(const std::vector<Problem>& problems);
/// Workflow commands of GitHub Actions, which annotate the lines of mistakes.
[[nodiscard]] std::string github_problems(const std::vector<Problem>& problems);

/// Writes a report to a file. Errors: it cannot be written.
[[nodiscard]] Result<void> write_report(const std::string& path, const std::string& text);

}  // namespace galilean::expect
