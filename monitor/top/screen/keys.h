// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace galilean::monitor::top {

enum class Key : std::uint8_t {
  kNone,
  kLetter,
  kUp,
  kDown,
  kLeft,
  kRight,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kTab,
  kEnter,
  kEscape,
  kBackspace,
  kStop,  ///< Ctrl-X
  kClick,
  kWheelUp,
  kWheelDown,
  kOther  ///< a key that the dashboard does not know
};

/// A key that was pressed, or a move of the mouse.
struct Press {
  Key key = Key::kNone;
  char letter = 0;          ///< the ASCII character of kLetter
  int row = 0, column = 0;  ///< the cell under the mouse, from 0

  bool operator==(const Press&) const = default;
};

/// Takes keys out of what a terminal sends: characters, escape sequences as xterm has them, and
/// the mouse in its form 1006. Reports of the mouse in its old form are swallowed.
class KeyReader {
 public:
  void feed(std::string_view bytes) { bytes_ += bytes; }
  /// Returns the next key, or kNone. An escape sequence may come in pieces, so a lone ESC is the
  /// key Escape only if `is_all`: nothing followed for a moment.
  [[nodiscard]] Press take(bool is_all);
  /// Returns whether the beginning of a sequence waits for its rest.
  [[nodiscard]] bool is_pending() const noexcept { return !bytes_.empty(); }

 private:
  [[nodiscard]] Press take_sequence(bool is_all);
  [[nodiscard]] Press take_first(std::size_t count, const Press& press);

  std::string bytes_;
};

}  // namespace galilean::monitor::top
