// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// What a recorder tells of itself.
struct RecorderStatus {
  std::string name;  ///< by which commands call it
  std::string host;
  std::string file;                             ///< the one that was begun last; empty: none was
  std::optional<std::int64_t> paused_since_ns;  ///< nothing: it records
  std::uint64_t messages = 0;                   ///< recorded
  std::uint64_t missing = 0;                    ///< that should be recorded and are not
  std::string obeyed;                           ///< the id of the newest command; empty: none came
  bool operator==(const RecorderStatus&) const = default;
};

/// Returns it as a message of the topic kRecorderStatusTopic. The level is 1, a warning, while it
/// is paused or anything is missing.
[[nodiscard]] msg::DiagnosticArray to_message(const RecorderStatus& status, std::int64_t now_ns);
/// Returns what the message tells; nothing if it is about something else.
[[nodiscard]] std::optional<RecorderStatus> read_status(const msg::DiagnosticArray& message);

}  // namespace galilean::monitor
