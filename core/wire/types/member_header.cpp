// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/member_header.h"

namespace galilean::wire {
namespace {

// XTypes 1.3, 7.4.1.2.
constexpr std::uint32_t kParameterId = 0x3FFF, kLongParameterId = 0x0FFF'FFFF;
constexpr std::uint32_t kLongHeader = 0x3F01, kEndOfList = 0x3F02, kIgnored = 0x3F03;

MemberHeader first_version(CdrCursor& cursor) {
  cursor.align(4);
  const std::uint32_t id = cursor.read<std::uint16_t>() & kParameterId;
  const std::size_t size = cursor.read<std::uint16_t>();
  if (id != kLongHeader) return {id, size};
  const std::uint32_t long_id = cursor.read<std::uint32_t>() & kLongParameterId;
  return {long_id, cursor.read<std::uint32_t>()};
}

/// XTypes 1.3, 7.4.3.4.2: a code in the header says how the size is told. From the fifth on, the
/// number that tells it is at the same time the first of the member.
std::optional<MemberHeader> second_version(CdrCursor& cursor) {
  cursor.align(4);
  if (cursor.left() == 0) return std::nullopt;
  const auto header = cursor.read<std::uint32_t>();
  const std::uint32_t id = header & kLongParameterId, code = header >> 28 & 7;
  if (code < 4) return MemberHeader{id, std::size_t{1} << code};
  if (code == 4) return MemberHeader{id, cursor.read<std::uint32_t>()};
  const std::size_t count = cursor.peek<std::uint32_t>();
  const std::size_t item = code == 5 ? 1 : code == 6 ? 4 : 8;
  return MemberHeader{id, sizeof(std::uint32_t) + count * item};
}

}  // namespace

std::optional<MemberHeader> next_member(CdrCursor& cursor) {
  for (;;) {
    const auto header = cursor.is_second() ? second_version(cursor) : first_version(cursor);
    if (!cursor.ok() || !header) return std::nullopt;
    if (cursor.is_second()) return header;
    if (header->id == kEndOfList) return std::nullopt;
    if (header->id != kIgnored) return header;
    cursor.read_bytes(header->size);
  }
}

MemberHeader optional_header(CdrCursor& cursor) {
  return first_version(cursor);
}

}  // namespace galilean::wire
