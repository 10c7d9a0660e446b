// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/summary_section.h"

#include <cstring>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/unpack.h"

namespace galilean::mcap {
namespace {

/// The largest summary that is read [bytes]; it is a thousandth of its file.
constexpr std::uint64_t kMaxSummaryBytes = kMaxBlockBytes;

template <class Record>
bool keep_numbered(ByteView content, std::map<std::uint16_t, Record>& to) {
  Record record;
  if (!parse(content, record)) return false;
  to[record.id] = std::move(record);
  return true;
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
      return parse(content, to.chunks.emplace_back());
    default:
      return opcode != Opcode{0};
  }
}

bool keep_summary_records(ByteView bytes, SummarySection& to) {
  while (!bytes.empty()) {
    std::uint64_t length = 0;
    if (bytes.size() < kRecordHead) return false;
    std::memcpy(&length, bytes.data() + 1, sizeof length);
    if (length > bytes.size() - kRecordHead) return false;
    const auto content = bytes.subspan(kRecordHead, static_cast<std::size_t>(length));
    if (!keep_summary_record(static_cast<Opcode>(bytes[0]), content, to)) return false;
    bytes = bytes.subspan(kRecordHead + content.size());
  }
  return true;
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
  if (footer_at - start > kMaxSummaryBytes) return damaged_summary(start, "is larger than 256 MiB");
  Bytes bytes(static_cast<std::size_t>(footer_at + kFooterBytes - start));
  if (!source.read(start, bytes)) return damaged_summary(start, "cannot be read");
  const auto summed = ByteView(bytes).first(bytes.size() - sizeof footer->summary_crc);
  if (footer->summary_crc != 0 && crc32(summed) != footer->summary_crc)
    return damaged_summary(start, "does not match its checksum");
  if (!keep_summary_records(ByteView(bytes).first(static_cast<std::size_t>(footer_at - start)),
                            section))
    return damaged_summary(start, "has a record that contradicts itself");
  section.closed = true;
  section.data_end = start;
  section.checked = footer->summary_crc != 0;
  return section;
}

}  // namespace galilean::mcap
