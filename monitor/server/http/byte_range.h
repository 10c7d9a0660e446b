// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace galilean::monitor {

/// The part of a file that a client asks for.
struct ByteRange {
  enum class Kind {
    kWhole,  ///< no range was asked for, or one that this server does not give, such as several
    kPart,   ///< `offset` and `bytes` say which
    kOutOfBounds  ///< nothing of it is in the file
  };
  Kind kind = Kind::kWhole;
  std::uint64_t offset = 0, bytes = 0;
};

/// Reads the field Range of a request for a file of `size` bytes (RFC 9110, 14.2): "bytes=0-99",
/// "bytes=100-" or "bytes=-100".
[[nodiscard]] ByteRange byte_range(std::string_view field, std::uint64_t size);

}  // namespace galilean::monitor
