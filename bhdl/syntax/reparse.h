// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/reading.h"

namespace galilean::bhdl {

/// Returns the same reading of `text` as read_text, made from the reading of an earlier version.
/// Only the items that the edit between the two touches, and those that were faulty, are read
/// again. All others are copied.
[[nodiscard]] Reading reread(const Reading& before, std::string_view file, std::string_view text);

}  // namespace galilean::bhdl
