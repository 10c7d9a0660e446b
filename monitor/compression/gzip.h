// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// `content` as one member of gzip's format (RFC 1952). `level`: 1 is quick, 9 is small.
[[nodiscard]] std::string gzipped(std::string_view content, int level);

}  // namespace galilean::monitor
