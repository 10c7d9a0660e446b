// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace galilean {

// The exit codes of all programs. README.md and the manual pages tell users of them.

inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
/// What was asked for is done as far as the data goes, of which a part is damaged or missing.
inline constexpr int kIncomplete = 3;

struct ExitCode {
  int code;
  const char* meaning;  ///< empty: only what CommandLine::describe_exit says, where it says it
};

inline constexpr std::array kExitCodes{
    ExitCode{0, "What was asked for is done, and is so."},
    ExitCode{kFailed, "What was asked for could not be done, or is not so."},
    ExitCode{kWrongUsage, "The command line is wrong, and nothing was begun."},
    ExitCode{kIncomplete, ""},
};

}  // namespace galilean
