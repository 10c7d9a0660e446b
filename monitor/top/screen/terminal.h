// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <termios.h>

#include <optional>
#include <string>

#include "core/result.h"
#include "monitor/top/screen/canvas.h"
#include "monitor/top/screen/keys.h"
#include "monitor/top/screen/palette.h"

namespace galilean::monitor::top {

/// The terminal in full-screen mode, as long as this process is in the foreground. The destructor
/// gives it back as it was, and so does a signal that ends the process at once, such as SIGSEGV or
/// SIGQUIT. At most one may exist at a time.
///
/// Nothing here waits for the terminal: if it takes nothing, as over a slow connection, the screens
/// in between are left out.
class Terminal {
 public:
  /// Errors: standard input or output is no terminal, or one that cannot be drawn on.
  [[nodiscard]] static Result<void> check(const Environment& environment);

  /// Requires: check() found nothing. With `mouse`, the terminal sends clicks and the wheel.
  Terminal(const Look& look, bool mouse);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  /// Asks how large the window is now.
  void measure();

  /// Shows the canvas, unless the terminal has not taken the screen before yet.
  void show(const Canvas& canvas);
  /// Sends what the terminal has not taken yet. Call it when `output` is writable.
  void flush();
  /// Returns whether something waits to be sent.
  [[nodiscard]] bool is_behind() const noexcept { return !unsent_.empty(); }
  /// Returns a file descriptor for poll.
  [[nodiscard]] int output() const noexcept { return output_; }

  /// Takes what was typed. Returns false if the terminal is gone.
  [[nodiscard]] bool read_keys();
  /// Returns the next key, or kNone. Never waits, except some milliseconds for the rest of an
  /// escape sequence.
  [[nodiscard]] Press take_key();

  /// Gives the terminal back for a while, as for a shell. In the background it leaves the terminal
  /// as it is, because it belongs to the shell already.
  void leave() noexcept;
  /// Takes it again, and draws the next screen whole. Does nothing in the background.
  void enter();
  /// Returns whether it may be drawn on and read from.
  [[nodiscard]] bool is_entered() const noexcept { return entered_; }

 private:
  Look look_;
  bool mouse_;
  bool entered_ = false;
  termios before_{};
  int output_;
  int columns_ = 80, rows_ = 24;
  std::optional<Canvas> shown_;
  std::string unsent_;
  KeyReader keys_;
};

}  // namespace galilean::monitor::top
