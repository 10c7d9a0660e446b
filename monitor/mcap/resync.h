// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/mcap/byte_window.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// Reads what stands in a chunk record before its records, from the record at `offset`.
/// Returns nothing if no chunk record that agrees with itself about its size begins there. The
/// chunk may be cut short by the end of the file.
[[nodiscard]] std::optional<Chunk> chunk_head_at(ByteWindow& window, std::uint64_t offset);

/// Returns the offset of the first chunk at or behind `offset`; nothing if there is none.
[[nodiscard]] std::optional<std::uint64_t> find_chunk(ByteWindow& window, std::uint64_t offset);

}  // namespace galilean::mcap
