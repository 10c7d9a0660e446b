// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/resync.h"

#include <algorithm>
#include <cstring>

#include "monitor/mcap/unpack.h"

namespace galilean::mcap {
namespace {

/// Two times, uncompressed size, checksum and the length of the compression's name.
constexpr std::size_t kChunkNameAt = kRecordHead + 8 + 8 + 8 + 4 + 4;
constexpr std::size_t kLongestName = 32;
constexpr std::size_t kSearched = 4096;

template <class Number>
Number number_in(ByteView bytes, std::size_t at) {
  Number number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

}  // namespace

std::optional<Chunk> chunk_head_at(ByteWindow& window, std::uint64_t offset) {
  const ByteView bytes = window.at(offset, kChunkNameAt + kLongestName + 8);
  if (bytes.size() < kChunkNameAt + 8 || bytes[0] != static_cast<std::uint8_t>(Opcode::kChunk))
    return {};
  const auto name_size = number_in<std::uint32_t>(bytes, kChunkNameAt - 4);
  if (name_size > kLongestName || kChunkNameAt + name_size + 8 > bytes.size()) return {};
  const auto records = number_in<std::uint64_t>(bytes, kChunkNameAt + name_size);
  const auto length = number_in<std::uint64_t>(bytes, 1);
  if (length != kChunkNameAt - kRecordHead + name_size + 8 + records) return {};
  Chunk chunk;
  chunk.start_ns = number_in<std::uint64_t>(bytes, kRecordHead);
  chunk.end_ns = number_in<std::uint64_t>(bytes, kRecordHead + 8);
  chunk.uncompressed_size = number_in<std::uint64_t>(bytes, kRecordHead + 16);
  const auto name = bytes.subspan(kChunkNameAt, name_size);
  chunk.compression.assign(name.begin(), name.end());
  return chunk;
}

std::optional<std::uint64_t> find_chunk(ByteWindow& window, std::uint64_t offset) {
  while (offset < window.end()) {
    const ByteView bytes = window.at(offset, kSearched);
    if (bytes.empty()) return {};
    const auto found = std::ranges::find(bytes, static_cast<std::uint8_t>(Opcode::kChunk));
    offset += static_cast<std::uint64_t>(found - bytes.begin());
    if (found == bytes.end()) continue;
    const auto chunk = chunk_head_at(window, offset);
    if (chunk &&
        (chunk->compression.empty() || chunk->compression == "zstd" || chunk->compression == "lz4"))
      return offset;
    ++offset;
  }
  return {};
}

}  // namespace galilean::mcap
