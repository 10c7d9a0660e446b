// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

enum class Colours : std::uint8_t { kNone, k16, k256, kTrue };

/// What a terminal can show.
struct Look {
  Colours colours = Colours::kNone;
  bool ascii = false;  ///< draw ASCII alone
};

/// Returns the value of an environment variable, or an empty string if it is not set.
using Environment = std::function<std::string(const char* name)>;
[[nodiscard]] std::string process_environment(const char* name);

/// Returns how many colours the terminal has, as NO_COLOR, COLORTERM and TERM say.
[[nodiscard]] Colours colours_of(const Environment& environment);
/// Returns whether the locale's characters are UTF-8, as LC_ALL, LC_CTYPE or LANG says. The
/// locale need not be installed on this machine.
[[nodiscard]] bool is_utf8(const Environment& environment);

/// Returns the escape sequence that makes the following text look so.
[[nodiscard]] std::string escape_sequence(Style style, Colours colours);

}  // namespace galilean::monitor::top
