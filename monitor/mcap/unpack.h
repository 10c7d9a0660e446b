// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// The largest chunk, message or metadata that is read [bytes]. No recorder makes larger ones, so a
/// larger size is damage, and no memory is taken for it.
inline constexpr std::uint64_t kMaxBlockBytes = std::uint64_t{256} << 20;

/// Decompresses a chunk's records into `to`, and checks them against the chunk's checksum.
/// Uncompressed records are checked where they lie, and `to` is left alone.
/// Returns what is wrong, as a predicate: "does not match its checksum"; nothing if all is right.
[[nodiscard]] std::string unpack(const Chunk& chunk, Bytes& to);

}  // namespace galilean::mcap
