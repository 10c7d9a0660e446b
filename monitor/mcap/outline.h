// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_reader.h"

namespace galilean::mcap {

/// What can be told of a recording at a glance, for lists of many.
struct Outline {
  std::uint64_t messages = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  ///< log times [ns since the Unix epoch]
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  bool closed = false;         ///< whether its recorder came to its end
  bool being_written = false;  ///< whether a recorder of Galilean writes it now
  bool damaged = false;        ///< whether damage was met; messages were not looked at
};

/// Reads the summary that a closed file has at its end, and takes its word. A file without one is
/// surveyed, and the messages are counted by their indexes.
/// Errors: as summarize().
[[nodiscard]] Result<Outline> outline(const ByteSource& source);

/// Errors: nothing of a file that was not closed can be read but its header, or not even that. The
/// message is a predicate.
[[nodiscard]] Result<void> check_content(const ByteSource& source, const Outline& outline);

}  // namespace galilean::mcap
