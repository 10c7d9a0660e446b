// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

// The exit codes of all programs. README.md tells users of them.

// 0: what was asked for is done, and so.
inline constexpr int kFailed = 1;      ///< what was asked for could not be done, or is not so
inline constexpr int kWrongUsage = 2;  ///< the command line is wrong, and nothing was begun

}  // namespace galilean
