// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace galilean {

/// Returns the keys whose bytes a terminal sent, one by one: a letter, or an escape sequence such
/// as that of an arrow. They point into `bytes`.
[[nodiscard]] std::vector<std::string_view> split_keys(std::string_view bytes);

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
  /// Returns the bytes of the keys since the last call. It never waits.
  [[nodiscard]] std::string read();

 private:
  std::optional<termios> before_;
};

}  // namespace galilean
