// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace galilean {

// The exit codes of all programs. README.md and the manual pages tell users of them.

inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
/// Of programs that describe it themselves: it is done as far as could be, and what is missing was
/// said.
inline constexpr int kIncomplete = 3;

struct ExitCode {
  int code;
  const char* meaning;
};

inline constexpr std::array kExitCodes{
    ExitCode{0, "What was asked for is done, and is so."},
    ExitCode{kFailed, "What was asked for could not be done, or is not so."},
    ExitCode{kWrongUsage, "The command line is wrong, and nothing was begun."},
};

}  // namespace galilean
