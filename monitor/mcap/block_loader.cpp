// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/block_loader.h"

#include <algorithm>
#include <cstring>

#include "monitor/mcap/message_indexes.h"
#include "monitor/mcap/unpack.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kMessageFields = 2 + 4 + 8 + 8;

template <class Record>
bool add_parsed(ByteView content, std::vector<Record>& to) {
  Record record;
  if (!parse(content, record)) return false;
  to.push_back(std::move(record));
  return true;
}

bool add_record(Opcode opcode, ByteView content, std::size_t offset, LoadedBlock& to) {
  if (opcode == Opcode::kSchema) return add_parsed(content, to.schemas);
  if (opcode == Opcode::kChannel) return add_parsed(content, to.channels);
  if (opcode != Opcode::kMessage) return true;
  if (content.size() < kMessageFields) return false;
  LoadedBlock::Entry entry{
      .log_ns = 0, .offset = static_cast<std::uint32_t>(offset), .channel_id = 0};
  std::memcpy(&entry.channel_id, content.data(), sizeof entry.channel_id);
  std::memcpy(&entry.log_ns, content.data() + 2 + 4, sizeof entry.log_ns);
  to.entries.push_back(entry);
  return true;
}

/// Fills `to` from its records, up to the first that is broken.
std::string list_records(LoadedBlock& to) {
  for (std::size_t at = 0; at < to.records.size();) {
    const auto rest = to.records.subspan(at);
    if (rest.size() < kRecordHead) return "ends within a record";
    std::uint64_t length = 0;
    std::memcpy(&length, rest.data() + 1, sizeof length);
    if (length > rest.size() - kRecordHead) return "ends within a record";
    const auto content = rest.subspan(kRecordHead, static_cast<std::size_t>(length));
    if (!add_record(static_cast<Opcode>(rest[0]), content, at, to))
      return "has a record that contradicts itself";
    at += kRecordHead + content.size();
  }
  return {};
}

void widen(std::optional<TimeRange>& range, std::uint64_t log_ns) {
  if (!range) range = TimeRange{log_ns, log_ns};
  range->start_ns = std::min(range->start_ns, log_ns);
  range->end_ns = std::max(range->end_ns, log_ns);
}

/// Adds the messages of all message indexes in `bytes` to `damage`. Returns false if an index is
/// damaged itself.
bool add_indexed(ByteView bytes, Damage& damage) {
  return for_each_message_index(bytes, [&](const MessageIndex& index) {
    damage.channel_messages[index.channel_id] += index.entries.size();
    *damage.messages += index.entries.size();
    for (const auto& entry : index.entries) widen(damage.time, entry.log_ns);
  });
}

}  // namespace

Message LoadedBlock::message(const Entry& entry) const {
  const auto record = records.subspan(entry.offset);
  std::uint64_t length = 0;
  std::memcpy(&length, record.data() + 1, sizeof length);
  Message message;
  (void)parse(record.subspan(kRecordHead, static_cast<std::size_t>(length)), message);
  return message;
}

std::size_t LoadedBlock::memory() const noexcept {
  return bytes.capacity() + entries.capacity() * sizeof(Entry);
}

void BlockLoader::load(const Block& block, LoadedBlock& to) {
  to.records = {};
  to.entries.clear();
  to.schemas.clear();
  to.channels.clear();
  to.damage.reset();
  const auto problem = read(block, to);
  if (!problem.empty()) to.damage = assess(block, problem, to);
  if (!std::ranges::is_sorted(to.entries, {}, &LoadedBlock::Entry::log_ns))
    std::ranges::stable_sort(to.entries, {}, &LoadedBlock::Entry::log_ns);
}

std::string BlockLoader::read(const Block& block, LoadedBlock& to) {
  const std::uint64_t head = block.is_chunk ? kRecordHead : 0;
  if (block.bytes < head || block.bytes > kMaxBlockBytes) return "claims to be larger than 256 MiB";
  stored_.resize(static_cast<std::size_t>(block.bytes - head));
  if (!source_.read(block.offset + head, stored_)) return "cannot be read";
  if (block.is_chunk) {
    Chunk chunk;
    if (!parse(stored_, chunk)) return "contradicts itself";
    if (auto problem = unpack(chunk, to.bytes); !problem.empty()) return problem;
    to.records = chunk.compression.empty() ? chunk.records : ByteView(to.bytes);
    // The records stay where they were read: the buffers change hands, which moves no byte.
    if (chunk.compression.empty()) std::swap(stored_, to.bytes);
  } else {
    to.records = stored_;
    std::swap(stored_, to.bytes);
  }
  return list_records(to);
}

Damage BlockLoader::assess(const Block& block, const std::string& problem,
                           const LoadedBlock& loaded) const {
  Damage damage{.what = (block.is_chunk ? "the chunk at byte " : "the messages from byte ") +
                        std::to_string(block.offset) + " on " + problem,
                .offset = block.offset};
  if (block.is_chunk)
    damage.what = "the chunk at byte " + std::to_string(block.offset) + " " + problem;
  const TimeRange stated{block.start_ns, block.end_ns};
  damage.time = stated;
  if (block.index_bytes == 0 || block.index_bytes > kMaxBlockBytes) return damage;
  Damage counted = damage;
  counted.time.reset();
  counted.messages = 0;
  Bytes indexes(static_cast<std::size_t>(block.index_bytes));
  if (!source_.read(block.index_offset, indexes) || !add_indexed(indexes, counted)) return damage;
  if (!counted.time) counted.time = stated;
  for (const auto& entry : loaded.entries) {  // those before the damage are not lost
    auto& count = counted.channel_messages[entry.channel_id];
    if (count == 0) continue;
    --count;
    --*counted.messages;
  }
  std::erase_if(counted.channel_messages, [](const auto& each) { return each.second == 0; });
  return counted;
}

}  // namespace galilean::mcap
