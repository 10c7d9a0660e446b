// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/mcap_reader.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/mcap_scan.h"

namespace galilean::mcap {
namespace {

constexpr std::uint64_t kFooterBytes = kRecordHead + 8 + 8 + 4;

bool has_magic(const ByteSource& source, std::uint64_t offset) {
  std::uint8_t magic[sizeof kMagic];
  return source.read(offset, magic) && std::memcmp(magic, kMagic, sizeof magic) == 0;
}

/// The records of the summary section.
struct SummarySection {
  std::uint64_t start = 0;
  Bytes bytes;
};

/// Returns nothing if the section or its footer is missing or damaged.
std::optional<SummarySection> read_section(const ByteSource& source) {
  const std::uint64_t size = source.size();
  if (size < 2 * sizeof kMagic + kFooterBytes || !has_magic(source, size - sizeof kMagic))
    return {};
  const std::uint64_t footer_at = size - sizeof kMagic - kFooterBytes;
  Opcode opcode{};
  Bytes content;
  Footer footer;
  if (!read_record(source, footer_at, opcode, content) || opcode != Opcode::kFooter ||
      !parse(content, footer) || footer.summary_start == 0 || footer.summary_start > footer_at)
    return {};
  SummarySection section{footer.summary_start, {}};
  section.bytes.resize(static_cast<std::size_t>(footer_at + kFooterBytes - footer.summary_start));
  if (!source.read(section.start, section.bytes)) return {};
  const auto summed = ByteView(section.bytes).first(section.bytes.size() - 4);
  if (footer.summary_crc != 0 && crc32(summed) != footer.summary_crc) return {};
  section.bytes.resize(section.bytes.size() - kFooterBytes);
  return section;
}

/// Adds a record of the summary section to `summary`. Returns false if the record, or the metadata
/// record that it points to, is damaged.
bool note(Opcode opcode, ByteView content, const ByteSource& source, Summary& summary) {
  if (opcode == Opcode::kSchema) {
    Schema schema;
    if (!parse(content, schema)) return false;
    summary.schemas[schema.id] = schema;
  } else if (opcode == Opcode::kChannel) {
    Channel channel;
    if (!parse(content, channel)) return false;
    summary.channels[channel.id] = channel;
  } else if (opcode == Opcode::kStatistics) {
    return parse(content, summary.statistics);
  } else if (opcode == Opcode::kChunkIndex) {
    ChunkIndex index;
    if (!parse(content, index)) return false;
    ++summary.compressions[index.compression];
  } else if (opcode == Opcode::kAttachmentIndex) {
    AttachmentIndex index;
    if (!parse(content, index)) return false;
    summary.attachments.push_back(index.name);
  } else if (opcode == Opcode::kMetadataIndex) {
    MetadataIndex index;
    Opcode found{};
    Bytes record;
    return parse(content, index) && read_record(source, index.offset, found, record) &&
           found == Opcode::kMetadata && parse(record, summary.metadata.emplace_back());
  }
  return true;
}

bool read_summary(const ByteSource& source, Summary& summary) {
  const auto section = read_section(source);
  if (!section) return false;
  const MemorySource records(section->bytes);
  Opcode opcode{};
  Bytes content;
  bool has_statistics = false;
  for (std::uint64_t at = 0; at < records.size(); at += kRecordHead + content.size()) {
    if (!read_record(records, at, opcode, content) || !note(opcode, content, source, summary))
      return false;
    has_statistics |= opcode == Opcode::kStatistics;
  }
  return has_statistics && read_record(source, sizeof kMagic, opcode, content) &&
         opcode == Opcode::kHeader && parse(content, summary.header);
}

void count(const Message& message, Statistics& statistics) {
  const bool first = statistics.messages++ == 0;
  ++statistics.channel_messages[message.channel_id];
  statistics.start_ns = first ? message.log_ns : std::min(statistics.start_ns, message.log_ns);
  statistics.end_ns = std::max(statistics.end_ns, message.log_ns);
}

Summary count_all(const ByteSource& source) {
  Summary summary;
  Statistics& statistics = summary.statistics;
  Visitor visitor;
  visitor.header = [&](const Header& header) { summary.header = header; };
  visitor.schema = [&](const Schema& schema) { summary.schemas[schema.id] = schema; };
  visitor.channel = [&](const Channel& channel) { summary.channels[channel.id] = channel; };
  visitor.message = [&](const Message& message) { count(message, statistics); };
  visitor.attachment = [&](const Attachment& attachment) {
    summary.attachments.push_back(attachment.name);
  };
  visitor.metadata = [&](const Metadata& metadata) { summary.metadata.push_back(metadata); };
  visitor.chunk = [&](const Chunk& chunk) {
    ++statistics.chunks;
    ++summary.compressions[chunk.compression];
  };
  const ScanEnd end = scan(source, visitor);
  summary.damage = end.damage;
  summary.recovered =
      !end.complete || !end.damage.empty() || !has_magic(source, source.size() - sizeof kMagic);
  statistics.schemas = static_cast<std::uint16_t>(summary.schemas.size());
  statistics.channels = static_cast<std::uint32_t>(summary.channels.size());
  statistics.attachments = static_cast<std::uint32_t>(summary.attachments.size());
  statistics.metadata = static_cast<std::uint32_t>(summary.metadata.size());
  return summary;
}

}  // namespace

Result<Summary> summarize(const ByteSource& source) {
  if (source.size() == 0) return Error{"is empty: nothing was recorded"};
  if (!has_magic(source, 0)) return Error{"is not an MCAP file"};
  Summary summary;
  if (!read_summary(source, summary)) summary = count_all(source);
  summary.bytes = source.size();
  return summary;
}

}  // namespace galilean::mcap
