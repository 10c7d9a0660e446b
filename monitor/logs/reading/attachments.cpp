// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/reading/attachments.h"

#include <algorithm>
#include <cstring>

#include "monitor/mcap/crc32.h"

namespace galilean::logs {
namespace {

constexpr std::uint64_t kPieceBytes = std::uint64_t{1} << 20;

}  // namespace

bool is_whole(const mcap::ByteSource& source, const mcap::Attachment& attachment) {
  mcap::Bytes piece;
  mcap::append_head(piece, attachment);
  std::uint32_t sum = mcap::crc32(mcap::ByteView(piece).subspan(mcap::kRecordHead));
  for (std::uint64_t done = 0; done < attachment.data_bytes; done += piece.size()) {
    piece.resize(static_cast<std::size_t>(std::min(kPieceBytes, attachment.data_bytes - done)));
    if (!source.read(attachment.data_offset + done, piece)) return false;
    sum = mcap::crc32(piece, sum);
  }
  std::uint8_t stored[sizeof sum];
  if (!source.read(attachment.data_offset + attachment.data_bytes, stored)) return false;
  std::uint32_t expected = 0;
  std::memcpy(&expected, stored, sizeof expected);
  return expected == 0 || expected == sum;
}

}  // namespace galilean::logs
