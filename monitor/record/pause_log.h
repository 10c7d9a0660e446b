// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// Where a file tells when its recorder was paused: a topic, when a pause begins and when it ends,
/// and metadata at the file's end.
inline constexpr const char* kPausesTopic = "/recorder/pauses";
inline constexpr const char* kPausesMetadata = "pauses";

/// A time in which a recording was paused, so that nothing was recorded and nothing was lost.
struct Pause {
  std::int64_t from_ns = 0;           ///< since the Unix epoch
  std::optional<std::int64_t> to_ns;  ///< nothing: it has not ended yet
  std::uint64_t messages = 0;         ///< that came meanwhile
  std::string by;                     ///< who asked for it, such as a user's name
  bool operator==(const Pause&) const = default;
};

[[nodiscard]] nlohmann::ordered_json json_of(const Pause& pause);
/// Reads what json_of made. Returns nothing if it is something else.
[[nodiscard]] std::optional<Pause> read_pause(std::string_view json);
/// Returns a clause such as "paused by anna from 12:00:01 to 12:00:13 (12.0 s), 240 messages not
/// recorded", with dates.
[[nodiscard]] std::string pause_text(const Pause& pause);

/// Writes into a file when its recorder was paused.
class PauseLog {
 public:
  /// Requires: `writer` outlives this.
  explicit PauseLog(mcap::Writer& writer) : writer_(writer) {}

  /// Writes to the topic that a pause has begun, or ended. Errors: the file cannot be written.
  [[nodiscard]] Result<void> tell(const Pause& pause);
  /// Writes all pauses as metadata, if there were any. Errors: the file cannot be written.
  [[nodiscard]] Result<void> conclude();

 private:
  mcap::Writer& writer_;
  std::uint16_t channel_ = 0;  ///< 0: nothing was told yet
  std::uint32_t sequence_ = 0;
  std::vector<Pause> pauses_;
};

}  // namespace galilean::monitor
