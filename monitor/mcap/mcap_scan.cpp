// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/mcap_scan.h"

#include <cstring>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/zstd.h"

namespace galilean::mcap {
namespace {

/// The largest chunk that is read. No recorder makes larger chunks, so a larger size is damage, and
/// no memory is allocated for it.
constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{256} << 20;

template <class Record>
bool pass_on(ByteView content, const std::function<void(const Record&)>& to) {
  Record record;
  if (!parse(content, record)) return false;
  if (to) to(record);
  return true;
}

bool visit(Opcode opcode, ByteView content, const Visitor& visitor) {
  switch (opcode) {
    case Opcode::kHeader:
      return pass_on(content, visitor.header);
    case Opcode::kSchema:
      return pass_on(content, visitor.schema);
    case Opcode::kChannel:
      return pass_on(content, visitor.channel);
    case Opcode::kMessage:
      return pass_on(content, visitor.message);
    case Opcode::kAttachment:
      return pass_on(content, visitor.attachment);
    case Opcode::kMetadata:
      return pass_on(content, visitor.metadata);
    default:
      return true;
  }
}

std::string unpack(const Chunk& chunk, Bytes& records) {
  if (chunk.uncompressed_size > kMaxChunkBytes) return "claims to be too large";
  if (chunk.compression == "zstd") {
    records.resize(static_cast<std::size_t>(chunk.uncompressed_size));
    if (!decompress(chunk.records, records)) return "cannot be decompressed";
  } else if (chunk.compression.empty()) {
    records.assign(chunk.records.begin(), chunk.records.end());
  } else {
    return "is compressed by " + chunk.compression + ", which is not read here";
  }
  if (chunk.uncompressed_crc != 0 && crc32(records) != chunk.uncompressed_crc)
    return "does not match its checksum";
  return {};
}

/// Returns the length of the content behind a record's head.
std::uint64_t content_length(const std::uint8_t* head) {
  std::uint64_t length = 0;
  std::memcpy(&length, head + 1, sizeof length);
  return length;
}

bool is_enough(const Visitor& visitor) {
  return visitor.enough && visitor.enough();
}

std::string visit_records(ByteView records, const Visitor& visitor) {
  while (!records.empty() && !is_enough(visitor)) {
    if (records.size() < kRecordHead) return "ends within a record";
    const auto opcode = static_cast<Opcode>(records[0]);
    const auto length = content_length(records.data());
    records = records.subspan(kRecordHead);
    if (length > records.size()) return "ends within a record";
    if (!visit(opcode, records.first(static_cast<std::size_t>(length)), visitor))
      return "has a record that contradicts itself";
    records = records.subspan(static_cast<std::size_t>(length));
  }
  return {};
}

std::string visit_chunk(ByteView content, const Visitor& visitor, Bytes& records) {
  Chunk chunk;
  if (!parse(content, chunk)) return "contradicts itself";
  if (auto problem = unpack(chunk, records); !problem.empty()) return problem;
  if (visitor.chunk) visitor.chunk(chunk);
  return visit_records(records, visitor);
}

}  // namespace

bool read_record(const ByteSource& source, std::uint64_t offset, Opcode& opcode, Bytes& content) {
  std::uint8_t head[kRecordHead];
  if (!source.read(offset, head)) return false;
  const std::uint64_t length = content_length(head), start = offset + kRecordHead;
  if (length > source.size() || start > source.size() - length) return false;
  opcode = static_cast<Opcode>(head[0]);
  content.resize(static_cast<std::size_t>(length));
  return source.read(start, content);
}

ScanEnd scan(const ByteSource& source, const Visitor& visitor) {
  ScanEnd end{.offset = sizeof kMagic};
  Bytes content, records;
  Opcode opcode{};
  while (!is_enough(visitor) && read_record(source, end.offset, opcode, content)) {
    const std::string at = " at byte " + std::to_string(end.offset) + " ";
    end.complete = opcode == Opcode::kDataEnd;
    if (end.complete) break;
    if (opcode == Opcode::kChunk) {
      if (const auto problem = visit_chunk(content, visitor, records); !problem.empty())
        end.damage.push_back("the chunk" + at + problem);
    } else if (!visit(opcode, content, visitor)) {
      end.damage.push_back("the record" + at + "contradicts itself");
    }
    end.offset += kRecordHead + content.size();
  }
  return end;
}

}  // namespace galilean::mcap
