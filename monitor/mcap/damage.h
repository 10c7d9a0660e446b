// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace galilean::mcap {

/// A range of log times [ns since the Unix epoch], with both ends.
struct TimeRange {
  std::uint64_t start_ns = 0, end_ns = 0;
  bool operator==(const TimeRange&) const = default;
};

/// A part of a recording that cannot be read, and what was in it as far as the rest tells.
struct Damage {
  std::string what;          ///< a clause without a full stop: "the chunk at byte 17 is cut short"
  std::uint64_t offset = 0;  ///< bytes from the start of the file
  std::optional<TimeRange> time;          ///< of the lost messages; nothing if unknown
  std::optional<std::uint64_t> messages;  ///< number of lost messages; nothing if unknown
  std::map<std::uint16_t, std::uint64_t> channel_messages;  ///< of these, by channel id
};

}  // namespace galilean::mcap
