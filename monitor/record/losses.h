// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// The metadata of each file that tells who recorded it, where and with what.
inline constexpr const char* kRecorderMetadata = "galilean";

/// Where a file tells what it lacks: a topic, whenever more was lost, and metadata at its end. What
/// had been told when it began stands in metadata, too.
inline constexpr const char* kLossesTopic = "/recorder/losses";
inline constexpr const char* kLossesMetadata = "losses";
inline constexpr const char* kLossesBeforeMetadata = "losses before";

/// What a recording has, and lacks, of what one writer sent on a topic, since it began.
struct WriterLosses {
  std::string topic;    ///< "/io/state"
  std::string process;  ///< the name with which the writer's process joined, or its GUID
  std::string writer;   ///< its own GUID, which no other writer has
  std::uint64_t recorded = 0;
  /// Of `recorded`: events of a robot that came late, and fill a gap in which it was not heard.
  std::uint64_t filled = 0;
  /// Sent between the first and the last that came. Nothing: it cannot be known on a topic with
  /// keys, whose writers number what ends a key, too.
  std::optional<std::uint64_t> lost = 0;
  std::uint64_t overrun = 0;      ///< of `lost`: missed while the recorder's own queue was full
  std::uint64_t sent_before = 0;  ///< sent before the first that came
  std::uint64_t unwritten = 0;    ///< came while there was no room to write them
  std::uint64_t left_out = 0;     ///< pictures beyond what they may take; nobody misses them
  std::uint64_t paused = 0;       ///< sent while the recording was paused; nobody misses them

  /// Returns how many should be here and are not.
  [[nodiscard]] std::uint64_t missing() const noexcept { return lost.value_or(0) + unwritten; }
  bool operator==(const WriterLosses&) const = default;
};

/// Returns how many messages are missing, of all writers.
[[nodiscard]] std::uint64_t total_missing(const std::vector<WriterLosses>& losses) noexcept;

[[nodiscard]] nlohmann::ordered_json json_of(const WriterLosses& losses);
/// Reads what json_of made. Returns nothing if it is something else.
[[nodiscard]] std::optional<WriterLosses> read_losses(std::string_view json);

/// Returns what one writer's losses are beyond those that were told of it before.
[[nodiscard]] WriterLosses beyond(WriterLosses losses, const WriterLosses& before) noexcept;

/// Returns what a file lacks, as the metadata of this name.
[[nodiscard]] mcap::Metadata losses_metadata(const char* name,
                                             const std::vector<WriterLosses>& losses);

/// Writes into a file what it lacks.
class LossLog {
 public:
  /// Requires: `writer` outlives this.
  explicit LossLog(mcap::Writer& writer) : writer_(writer) {}

  /// Writes what was told at the end of the file before. Call it first. Errors: the file cannot be
  /// written.
  [[nodiscard]] Result<void> begin(const std::vector<WriterLosses>& before);
  /// Writes what has changed since the last call to the topic. Errors: the file cannot be written.
  [[nodiscard]] Result<void> tell(const std::vector<WriterLosses>& losses, std::int64_t now_ns);
  /// Writes all of it as metadata. Errors: the file cannot be written.
  [[nodiscard]] Result<void> conclude(const std::vector<WriterLosses>& losses);

 private:
  [[nodiscard]] Result<void> write(const WriterLosses& losses, std::int64_t now_ns);

  mcap::Writer& writer_;
  std::uint16_t channel_ = 0;  ///< 0: nothing was told yet
  std::uint32_t sequence_ = 0;
  /// How many are missing and how many fill gaps, together, by writer. Both only grow.
  std::map<std::string, std::uint64_t> told_;
};

}  // namespace galilean::monitor
