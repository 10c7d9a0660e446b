// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <queue>

#include "monitor/mcap/block_loader.h"

namespace galilean::mcap {

/// Reads the messages of a recording in the order of their log times, and lists what is damaged.
///
/// Blocks are read in the order in which they begin, and those that overlap are merged. Memory is
/// bounded: if too many blocks overlap, those whose next message is the furthest away are dropped
/// and read again when their turn comes. Messages of one log time come in the order of the file.
class MessageReader {
 public:
  /// The part of a recording that is read: messages of log times from `from_ns` on, and of the
  /// blocks for which `reads` returns true, or of all if it is empty.
  struct Part {
    std::uint64_t from_ns = 0;
    std::function<bool(std::uint32_t block)> reads = {};
  };

  /// @param blocks  what survey() found; it and `source` must outlive the reader
  /// @param memory_bytes  the memory for blocks; one block is held in any case
  MessageReader(const ByteSource& source, const std::vector<Block>& blocks,
                std::size_t memory_bytes = std::size_t{48} << 20)
      : MessageReader(source, blocks, memory_bytes, Part()) {}
  MessageReader(const ByteSource& source, const std::vector<Block>& blocks,
                std::size_t memory_bytes, Part part);

  /// Returns the next message; nothing after the last. Its data is valid until the next call.
  [[nodiscard]] const Message* next();

  /// Returns how much of the blocks was opened, from 0 to 1.
  [[nodiscard]] double progress() const noexcept {
    return order_.empty() ? 1 : static_cast<double>(opened_) / static_cast<double>(order_.size());
  }
  /// Returns the damage that was met so far.
  [[nodiscard]] const std::vector<Damage>& damages() const noexcept { return damages_; }
  /// Returns the schemas and channels that were met in blocks so far.
  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const noexcept { return schemas_; }
  [[nodiscard]] const std::map<std::uint16_t, Channel>& channels() const noexcept {
    return channels_;
  }

 private:
  /// The next message of an open block. The one with the least key is next of all.
  struct Turn {
    std::uint64_t log_ns;
    std::uint32_t block;
    std::uint32_t entry;
    [[nodiscard]] bool operator>(const Turn& other) const noexcept {
      return log_ns != other.log_ns ? log_ns > other.log_ns : block > other.block;
    }
  };

  void open_due();
  [[nodiscard]] bool next_block_is_due() const;
  void open(std::uint32_t block);
  LoadedBlock& loaded(const Turn& turn);
  void hold(const Turn& turn, std::unique_ptr<LoadedBlock> content);
  void make_room(std::uint32_t keep);
  void pass_turn();
  void release(std::uint32_t block);

  struct Held {
    std::unique_ptr<LoadedBlock> content;
    std::uint64_t next_ns = 0;
  };

  const std::vector<Block>& blocks_;
  std::size_t memory_bytes_;
  Part part_;
  BlockLoader loader_;
  std::vector<std::uint32_t> order_;  ///< the blocks, in the order in which they begin
  std::size_t opened_ = 0;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> turns_;
  std::map<std::uint32_t, Held> held_;
  std::size_t held_bytes_ = 0;
  std::unique_ptr<LoadedBlock> spare_;
  bool turn_is_taken_ = false;
  Message message_;
  std::vector<Damage> damages_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace galilean::mcap
