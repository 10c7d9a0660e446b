// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::expect {

/// Why nothing was judged: a mistake in expectations, a recording that cannot be read, or a run
/// that came to nothing.
struct Problem {
  std::string message;  ///< one line or several
  std::string file;     ///< where it is; empty: in no file
  int line = 0, column = 0;
};

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
