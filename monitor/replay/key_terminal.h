// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::monitor {

/// What a key asks of a replay.
enum class ReplayKey { kPause, kStep, kFaster, kSlower, kForward, kBack, kBegin, kEnd };

/// Returns what the keys ask for whose bytes a terminal sent. Other keys ask for nothing.
[[nodiscard]] std::vector<ReplayKey> keys_in(std::string_view bytes);

/// Reads keys from the terminal on standard input as they are pressed, if there is one and this
/// process is in its foreground. The destructor leaves the terminal as it was.
class KeyTerminal {
 public:
  KeyTerminal();
  ~KeyTerminal();
  KeyTerminal(const KeyTerminal&) = delete;
  KeyTerminal& operator=(const KeyTerminal&) = delete;

  [[nodiscard]] bool is_there() const noexcept { return before_.has_value(); }
  /// Returns a file descriptor for poll; a negative one, which poll ignores, if there is no
  /// terminal, or this process is in its background.
  [[nodiscard]] int descriptor() const noexcept;
  /// Returns what was asked for since the last call. It never waits.
  [[nodiscard]] std::vector<ReplayKey> read();

 private:
  std::optional<termios> before_;
};

}  // namespace galilean::monitor
