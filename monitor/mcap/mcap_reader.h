// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/result.h"
#include "monitor/mcap/recording_time.h"
#include "monitor/mcap/survey.h"

namespace galilean::mcap {

/// The contents of a recording. What its data section holds counts, and not what its summary says.
struct Summary {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;                              ///< of what can be read
  std::map<std::string, std::uint32_t> compressions;  ///< number of chunks; "" is uncompressed
  std::vector<Metadata> metadata;
  std::vector<Attachment> attachments;
  std::vector<Block> blocks;   ///< where its messages are; for a MessageReader
  std::uint64_t bytes = 0;     ///< size of the file
  bool closed = true;          ///< whether its recorder came to its end
  bool being_written = false;  ///< whether a recorder of Galilean writes it now
  bool checked = false;        ///< whether all messages were read, and every checksum compared
  std::vector<Damage> damages;
  std::map<std::uint16_t, std::uint64_t> lost;  ///< number of lost messages by channel, as known
  bool lost_is_exact = true;                    ///< whether no other message is lost
  std::vector<TimeRange> silences;  ///< those over kLongestSilence_ns; found only if checked

  /// Returns whether a part of the recording is damaged or missing.
  [[nodiscard]] bool recovered() const { return (!closed && !being_written) || !damages.empty(); }
};

/// How much of the messages is read.
enum class Depth {
  kIndexes,   ///< none that message indexes spare; damage in blocks is then not found
  kAsNeeded,  ///< all if the recording has at most kCheckedBytes, or its summary does not suffice
  kAll        ///< all, so that every damage is found
};
/// A recording of this many uncompressed bytes is read in less than a second.
inline constexpr std::uint64_t kCheckedBytes = std::uint64_t{256} << 20;

/// Returns whether the file begins as an MCAP file does, or nearly so.
/// Errors: it is empty or another kind of file. The message is a predicate, so that the caller can
/// put the file's name before it.
[[nodiscard]] Result<void> check_format(const ByteSource& source);

/// Returns whether the header can be read that a recording begins with.
/// Errors: as check_format(), or there is no such header. The message is a predicate, too.
[[nodiscard]] Result<void> check_header(const ByteSource& source);

/// Gets how much of a task is done, from 0 to 1; may be empty.
using Progress = std::function<void(double)>;

/// Reads what a file holds.
/// Errors: as check_format().
[[nodiscard]] Result<Summary> summarize(const ByteSource& source, Depth depth = Depth::kAsNeeded,
                                        const Progress& progress = {});

}  // namespace galilean::mcap
