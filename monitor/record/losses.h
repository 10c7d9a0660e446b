// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// What a recording has, and lacks, of what one writer sent on a topic.
struct WriterLosses {
  std::string topic;    ///< "/io/state"
  std::string process;  ///< the name with which the writer's process joined, or its GUID
  std::uint64_t recorded = 0;
  /// Sent between the first and the last that came. Nothing: it cannot be known on a topic with
  /// keys, whose writers number what ends a key, too.
  std::optional<std::uint64_t> lost = 0;
  std::uint64_t sent_before = 0;  ///< sent before the first that came
  std::uint64_t unwritten = 0;    ///< came while there was no room to write them
  bool operator==(const WriterLosses&) const = default;
};

/// Returns how many messages were lost or not written, of all writers.
[[nodiscard]] std::uint64_t total_missing(const std::vector<WriterLosses>& losses) noexcept;

/// Writes into a recording what it lacks: on the topic /recorder/losses whenever more was lost, and
/// as the metadata "losses" at its end.
class LossLog {
 public:
  /// Requires: `writer` outlives this.
  explicit LossLog(mcap::Writer& writer) : writer_(writer) {}

  /// Writes what has changed since the last call. Errors: the file cannot be written.
  [[nodiscard]] Result<void> tell(const std::vector<WriterLosses>& losses, std::int64_t now_ns);
  /// Writes all of it. Errors: the file cannot be written.
  [[nodiscard]] Result<void> conclude(const std::vector<WriterLosses>& losses);

 private:
  mcap::Writer& writer_;
  std::uint16_t channel_ = 0;  ///< 0: nothing was told yet
  std::uint32_t sequence_ = 0;
  std::vector<WriterLosses> told_;
};

}  // namespace galilean::monitor
