// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/reading.h"

namespace galilean::bhdl {

/// The reading of `text`, the same as read_text gives, made of that of an earlier version: only the
/// items that an edit between the two touches, and those in which something was wrong, are read
/// again. What stands before and behind them is copied.
[[nodiscard]] Reading reread(const Reading& before, std::string_view file, std::string_view text);

}  // namespace galilean::bhdl
