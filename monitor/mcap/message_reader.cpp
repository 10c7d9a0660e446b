// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/message_reader.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace galilean::mcap {
namespace {

/// A block that contradicts itself about its times may have any.
bool ends_before(const Block& block, std::uint64_t time_ns) {
  return block.start_ns <= block.end_ns && block.end_ns < time_ns;
}

}  // namespace

MessageReader::MessageReader(const ByteSource& source, const std::vector<Block>& blocks,
                             std::size_t memory_bytes, Part part)
    : blocks_(blocks), memory_bytes_(memory_bytes), part_(std::move(part)), loader_(source) {
  for (std::uint32_t block = 0; block < blocks.size(); ++block)
    if (!ends_before(blocks[block], part_.from_ns)) order_.push_back(block);
  std::ranges::stable_sort(order_, {}, [&](std::uint32_t block) { return blocks[block].start_ns; });
}

const Message* MessageReader::next() {
  if (std::exchange(turn_is_taken_, false)) pass_turn();
  while (true) {
    open_due();
    if (turns_.empty()) return nullptr;
    const Turn turn = turns_.top();
    const LoadedBlock& block = loaded(turn);
    if (turn.entry >= block.entries.size()) {  // the file has changed since it was opened
      turns_.pop();
      release(turn.block);
      continue;
    }
    turn_is_taken_ = true;
    message_ = block.message(block.entries[turn.entry]);
    return &message_;
  }
}

void MessageReader::open_due() {
  while (next_block_is_due()) {
    const auto block = order_[opened_++];
    if (!part_.reads || part_.reads(block)) open(block);
  }
}

bool MessageReader::next_block_is_due() const {
  if (opened_ == order_.size()) return false;
  if (turns_.empty()) return true;
  const std::uint32_t block = order_[opened_];
  const Turn& first = turns_.top();
  return std::tie(blocks_[block].start_ns, block) < std::tie(first.log_ns, first.block);
}

void MessageReader::open(std::uint32_t block) {
  auto content = spare_ ? std::move(spare_) : std::make_unique<LoadedBlock>();
  loader_.load(blocks_[block], *content);
  if (content->damage) damages_.push_back(*content->damage);
  for (auto& schema : content->schemas) schemas_.insert_or_assign(schema.id, schema);
  for (auto& channel : content->channels) channels_.insert_or_assign(channel.id, channel);
  const auto first =
      std::ranges::lower_bound(content->entries, part_.from_ns, {}, &LoadedBlock::Entry::log_ns);
  if (first == content->entries.end()) {
    spare_ = std::move(content);
    return;
  }
  const Turn turn{first->log_ns, block,
                  static_cast<std::uint32_t>(first - content->entries.begin())};
  turns_.push(turn);
  hold(turn, std::move(content));
}

void MessageReader::hold(const Turn& turn, std::unique_ptr<LoadedBlock> content) {
  held_bytes_ += content->memory();
  held_[turn.block] = {std::move(content), turn.log_ns};
  make_room(turn.block);
}

/// Drops the blocks whose turn is the furthest away, but not `keep`.
void MessageReader::make_room(std::uint32_t keep) {
  while (held_bytes_ > memory_bytes_ && held_.size() > 1) {
    const auto later = [&](const auto& a, const auto& b) {
      return std::pair(a.first != keep, a.second.next_ns) <
             std::pair(b.first != keep, b.second.next_ns);
    };
    release(std::ranges::max_element(held_, later)->first);
  }
}

LoadedBlock& MessageReader::loaded(const Turn& turn) {
  if (const auto held = held_.find(turn.block); held != held_.end()) return *held->second.content;
  auto content = spare_ ? std::move(spare_) : std::make_unique<LoadedBlock>();
  loader_.load(blocks_[turn.block], *content);
  hold(turn, std::move(content));
  return *held_.at(turn.block).content;
}

void MessageReader::pass_turn() {
  Turn turn = turns_.top();
  turns_.pop();
  Held& held = held_.at(turn.block);
  if (++turn.entry == held.content->entries.size()) return release(turn.block);
  turn.log_ns = held.next_ns = held.content->entries[turn.entry].log_ns;
  turns_.push(turn);
}

void MessageReader::release(std::uint32_t block) {
  const auto held = held_.find(block);
  if (held == held_.end()) return;
  held_bytes_ -= held->second.content->memory();
  spare_ = std::move(held->second.content);
  held_.erase(held);
}

}  // namespace galilean::mcap
