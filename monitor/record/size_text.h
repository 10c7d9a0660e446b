// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean::monitor {

/// Reads a size as users write it: "500MB", "2 GB", "64KiB" or a number of bytes.
/// Errors: it is none, is negative or has no unit that is known. The error is a sentence.
[[nodiscard]] Result<std::uint64_t> bytes_of(std::string_view text);

/// Returns a size in words, rounded down: "500 MB", "10 kB" or "7 bytes".
[[nodiscard]] std::string size_text(std::uint64_t bytes);

}  // namespace galilean::monitor
