// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// Calls `take` with each of the message indexes that `bytes` consists of. Returns false if one of
/// them is damaged; those before it were taken.
template <class Take>
[[nodiscard]] bool for_each_message_index(ByteView bytes, Take take) {
  MessageIndex index;
  while (!bytes.empty()) {
    std::uint64_t length = 0;
    if (bytes.size() < kRecordHead) return false;
    std::memcpy(&length, bytes.data() + 1, sizeof length);
    if (length > bytes.size() - kRecordHead) return false;
    const auto content = bytes.subspan(kRecordHead, static_cast<std::size_t>(length));
    if (bytes[0] != static_cast<std::uint8_t>(Opcode::kMessageIndex) || !parse(content, index))
      return false;
    take(index);
    bytes = bytes.subspan(kRecordHead + content.size());
  }
  return true;
}

}  // namespace galilean::mcap
