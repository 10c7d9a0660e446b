// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/summary_section.h"

#include <algorithm>
#include <cstring>

#include "monitor/mcap/byte_window.h"
#include "monitor/mcap/crc32.h"
#include "monitor/mcap/unpack.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kSummedAtOnce = std::size_t{1} << 20;

template <class Record>
bool keep_numbered(ByteView content, std::map<std::uint16_t, Record>& to) {
  Record record;
  if (!parse(content, record)) return false;
  to[record.id] = std::move(record);
  return true;
}

/// Leaves out where each channel's messages are indexed: of a recording of hours that is all that
/// its summary holds, and nobody asks for it.
bool keep_chunk_index(ByteView content, ChunkIndex& to) {
  const bool whole = parse(content, to);
  to.message_index_offsets.clear();
  return whole;
}

bool keep_summary_record(Opcode opcode, ByteView content, SummarySection& to) {
  switch (opcode) {
    case Opcode::kSchema:
      return keep_numbered(content, to.schemas);
    case Opcode::kChannel:
      return keep_numbered(content, to.channels);
    case Opcode::kStatistics:
      return parse(content, to.statistics.emplace());
    case Opcode::kChunkIndex:
      return keep_chunk_index(content, to.chunks.emplace_back());
    default:
      return opcode != Opcode{0};
  }
}

/// Takes the records from `at` to `end`, one after the other. Returns false if one contradicts
/// itself.
bool keep_summary_records(const ByteSource& source, std::uint64_t at, std::uint64_t end,
                          SummarySection& to) {
  ByteWindow window(source);
  while (at < end) {
    const auto head = window.at(at, kRecordHead);
    if (head.size() < kRecordHead || end - at < kRecordHead) return false;
    const auto opcode = static_cast<Opcode>(head[0]);
    std::uint64_t length = 0;
    std::memcpy(&length, head.data() + 1, sizeof length);
    at += kRecordHead;
    if (length > end - at || length > kMaxBlockBytes) return false;
    const auto content = window.at(at, static_cast<std::size_t>(length));
    if (content.size() < length || !keep_summary_record(opcode, content, to)) return false;
    at += length;
  }
  return true;
}

/// Returns the checksum of the bytes from `at` to `end`; nothing if they cannot be read.
std::optional<std::uint32_t> checksum_of(const ByteSource& source, std::uint64_t at,
                                         std::uint64_t end) {
  std::uint32_t crc = 0;
  for (Bytes bytes; at < end; at += bytes.size()) {
    bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kSummedAtOnce, end - at)));
    if (!source.read(at, bytes)) return std::nullopt;
    crc = crc32(bytes, crc);
  }
  return crc;
}

/// Returns the footer; nothing if the file does not end with one.
std::optional<Footer> read_footer(const ByteSource& source, std::uint64_t footer_at) {
  std::uint8_t bytes[kFooterBytes + sizeof kMagic];
  Footer footer;
  if (!source.read(footer_at, bytes) || bytes[0] != static_cast<std::uint8_t>(Opcode::kFooter) ||
      std::memcmp(bytes + kFooterBytes, kMagic, sizeof kMagic) != 0 ||
      !parse(ByteView(bytes).subspan(kRecordHead, kFooterBytes - kRecordHead), footer))
    return {};
  return footer;
}

SummarySection damaged_summary(std::uint64_t offset, const std::string& problem) {
  SummarySection section;
  section.closed = true;
  section.damage = Damage{.what = "the summary at byte " + std::to_string(offset) + " " + problem,
                          .offset = offset,
                          .messages = 0};
  return section;
}

}  // namespace

SummarySection read_summary_section(const ByteSource& source) {
  SummarySection section;
  const std::uint64_t size = source.size();
  if (size < 2 * sizeof kMagic + kFooterBytes) return section;
  const std::uint64_t footer_at = size - sizeof kMagic - kFooterBytes;
  const auto footer = read_footer(source, footer_at);
  if (!footer) return section;
  const std::uint64_t start = footer->summary_start == 0 ? footer_at : footer->summary_start;
  if (start < sizeof kMagic || start > footer_at)
    return damaged_summary(footer_at, "is said to begin outside the file");
  // Behind the data that it is about: a larger one would take longer to read than the data.
  if (footer_at - start > kMaxBlockBytes && footer_at - start > start)
    return damaged_summary(start, "is said to be larger than the data before it");
  const auto crc =
      checksum_of(source, start, footer_at + kFooterBytes - sizeof footer->summary_crc);
  if (!crc) return damaged_summary(start, "cannot be read");
  if (footer->summary_crc != 0 && crc != footer->summary_crc)
    return damaged_summary(start, "does not match its checksum");
  if (!keep_summary_records(source, start, footer_at, section))
    return damaged_summary(start, "has a record that contradicts itself");
  section.closed = true;
  section.data_end = start;
  section.checked = footer->summary_crc != 0;
  return section;
}

}  // namespace galilean::mcap
