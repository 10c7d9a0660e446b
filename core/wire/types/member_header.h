// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/wire/types/cdr_cursor.h"

namespace galilean::wire {

/// What stands before a member of a mutable struct, and in version 1 before an optional one.
struct MemberHeader {
  std::uint32_t id;
  std::size_t size;  ///< of the member [bytes]
};

/// Reads the header of the next member of a mutable struct. Returns nothing at the end of its
/// members, and where the message breaks.
[[nodiscard]] std::optional<MemberHeader> next_member(CdrCursor& cursor);

/// Reads the header of an optional member of another struct. Requires: the message is of version 1.
[[nodiscard]] MemberHeader optional_header(CdrCursor& cursor);

}  // namespace galilean::wire
