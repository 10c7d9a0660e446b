// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <set>

#include "monitor/mcap/message_reader.h"
#include "monitor/mcap/newest_messages.h"
#include "monitor/playback/recorded_topics.h"

namespace galilean::monitor {

/// Reads the wanted channels of a recording from any instant on. First come the messages that tell
/// how things stood then: the newest of each state, however old; of each event the last 64 of the
/// last 30 s; of anything else but commands each writer's newest of the last second. Memory is
/// bounded: 16 MB of blocks, or one block if that is larger, and one more that is looked up.
class RecordingCursor {
 public:
  using Channels = std::set<std::uint16_t>;

  /// Requires: `source`, `blocks` and `topics` outlive this.
  RecordingCursor(const mcap::ByteSource& source, const std::vector<mcap::Block>& blocks,
                  const std::vector<RecordedTopic>& topics);

  /// Goes on at an instant [log time, ns since the Unix epoch], forward or back.
  void move_to(std::uint64_t at_ns);
  /// Replaces the wanted channels. `at_ns` is the instant at which it stands: those that are new
  /// begin there.
  void want(Channels channels, std::uint64_t at_ns);

  /// Returns the next message, until take(), move_to() or want() is called. Returns nullptr if
  /// there is none, or if it takes long to find: then is_at_end() tells, and next() searches on.
  [[nodiscard]] const mcap::Message* next();
  /// Returns whether next() is from before the instant at which it was moved, so that it is due at
  /// once. Requires: next() returned a message.
  [[nodiscard]] bool next_is_past() const noexcept { return !past_.empty(); }
  /// Passes over the message that next() returned.
  void take();
  [[nodiscard]] bool is_at_end() const noexcept { return past_.empty() && !ahead_ && at_end_; }
  /// Returns the log time before which no message is left.
  [[nodiscard]] std::uint64_t read_until_ns() const noexcept;
  /// Returns the log time of what was read before the next message, be it wanted or not.
  [[nodiscard]] std::uint64_t read_before_ns() const noexcept { return read_before_ns_; }
  /// Returns whether the next message that is not past is of that log time.
  [[nodiscard]] bool goes_on_at(std::uint64_t log_ns);

  /// Returns the damage that was met since the last call.
  [[nodiscard]] std::vector<mcap::Damage> take_damages();

 private:
  void add_past(const Channels& channels, std::uint64_t at_ns);
  void open_reader(std::uint64_t at_ns);
  [[nodiscard]] bool has_wanted(std::uint32_t block);
  void search_ahead();

  const mcap::ByteSource& source_;
  const std::vector<mcap::Block>& blocks_;
  const std::vector<RecordedTopic>& topics_;
  mcap::BlockChannels block_channels_;
  mcap::NewestMessages newest_;
  Channels wanted_;
  std::deque<mcap::OwnedMessage> past_;
  mcap::Message past_front_;
  std::unique_ptr<mcap::MessageReader> reader_;
  const mcap::Message* ahead_ = nullptr;
  bool at_end_ = true;
  std::uint64_t read_until_ns_ = 0, read_before_ns_ = 0;
  std::size_t damages_seen_ = 0;  ///< of the reader's
  std::vector<mcap::Damage> damages_;
};

}  // namespace galilean::monitor
