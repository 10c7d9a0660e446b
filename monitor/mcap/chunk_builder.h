// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// Collects the records of one chunk, the range of their times and the message index of each
/// channel.
class ChunkBuilder {
 public:
  void add(const Schema& schema) { append(records_, schema); }
  void add(const Channel& channel) { append(records_, channel); }
  void add(const Message& message);
  /// Empties the builder for the next chunk and keeps its memory.
  void clear();

  [[nodiscard]] bool empty() const noexcept { return records_.empty(); }
  [[nodiscard]] ByteView records() const noexcept { return records_; }
  /// Returns the earliest log time of the messages [ns since the Unix epoch]; 0 without messages.
  /// `end_ns` returns the latest.
  [[nodiscard]] std::uint64_t start_ns() const noexcept { return start_ns_; }
  [[nodiscard]] std::uint64_t end_ns() const noexcept { return end_ns_; }
  /// Returns the message indexes by channel id. An index is empty if the channel has no message in
  /// this chunk.
  [[nodiscard]] const std::map<std::uint16_t, MessageIndex>& indexes() const noexcept {
    return indexes_;
  }

 private:
  Bytes records_;
  bool has_message_ = false;
  std::uint64_t start_ns_ = 0, end_ns_ = 0;
  std::map<std::uint16_t, MessageIndex> indexes_;
};

}  // namespace galilean::mcap
