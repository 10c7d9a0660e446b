// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/top/canvas.h"

namespace galilean::monitor::top {

/// The terminal, taken over for as long as this lives and given back as it was.
class Terminal {
 public:
  /// Throws std::runtime_error if standard output is none, or an unknown one.
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
    char letter = 0;  ///< of kOther
  };
  /// The next key, if one waits; never blocks.
  [[nodiscard]] Press take_key();
};

}  // namespace galilean::monitor::top
