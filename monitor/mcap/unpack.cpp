// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/unpack.h"

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/lz4.h"
#include "monitor/mcap/zstd.h"

namespace galilean::mcap {
namespace {

std::string expand(const Chunk& chunk, Bytes& to) {
  if (chunk.compression != "zstd" && chunk.compression != "lz4")
    return "is compressed by '" + chunk.compression + "', which is not read here";
  if (chunk.uncompressed_size > kMaxBlockBytes) return "claims to be larger than 256 MiB";
  to.resize(static_cast<std::size_t>(chunk.uncompressed_size));
  const bool done = chunk.compression == "zstd" ? decompress(chunk.records, to)
                                                : decompress_lz4(chunk.records, to);
  return done ? "" : "cannot be decompressed";
}

}  // namespace

std::string unpack(const Chunk& chunk, Bytes& to) {
  const bool stored = chunk.compression.empty();
  if (!stored)
    if (auto problem = expand(chunk, to); !problem.empty()) return problem;
  const ByteView records = stored ? chunk.records : ByteView(to);
  if (records.size() != chunk.uncompressed_size) return "contradicts itself about its size";
  if (chunk.uncompressed_crc != 0 && crc32(records) != chunk.uncompressed_crc)
    return "does not match its checksum";
  return {};
}

}  // namespace galilean::mcap
