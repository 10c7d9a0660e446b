// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// Returns `content` as one member of gzip's format (RFC 1952). `level` is zlib's, from 1 (quick)
/// to 9 (small). Throws std::runtime_error if zlib cannot start.
[[nodiscard]] std::string gzipped(std::string_view content, int level);

}  // namespace galilean::monitor
