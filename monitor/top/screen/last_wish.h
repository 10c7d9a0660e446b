// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

#include <string_view>

namespace galilean::monitor::top {

/// Gives the terminal back if a signal ends the process at once, such as SIGSEGV, SIGABRT or
/// SIGQUIT. The signal then does what it does without this.
class LastWish {
 public:
  /// Requires: `bytes` lives as long as the process.
  static void arm(const termios& mode, std::string_view bytes) noexcept;
  static void disarm() noexcept;
};

}  // namespace galilean::monitor::top
