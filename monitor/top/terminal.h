// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/top/canvas.h"

namespace galilean::monitor::top {

/// The terminal in full-screen mode. The destructor restores it. At most one may exist at a time.
class Terminal {
 public:
  /// Throws std::runtime_error if standard output is no terminal, or one of an unknown type.
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int columns() const;
  [[nodiscard]] int rows() const;
  void show(const Canvas& canvas);

  enum class Key { kNone, kUp, kDown, kResized, kOther };
  struct Press {
    Key key = Key::kNone;
    char letter = 0;  ///< the ASCII character of kOther, else 0
  };
  /// Returns the next key that was pressed, or kNone. Never blocks.
  [[nodiscard]] Press take_key();
};

}  // namespace galilean::monitor::top
