// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/wire/types/cdr_cursor.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// Reads a whole number, letter, enum or bitmask, as the bits that it is encoded as.
[[nodiscard]] std::uint64_t read_bits(const wire::TypeDescription& type, wire::CdrCursor& cursor);
/// Returns such a value as people read it.
[[nodiscard]] MessageTree tree_of_bits(const wire::TypeDescription& type, std::uint64_t bits);
/// Returns whether the value of a union's discriminator is this label.
[[nodiscard]] bool is_label(const wire::TypeDescription& type, std::uint64_t bits,
                            std::int32_t label);

/// Reads a number, letter, enum, bitmask or text.
[[nodiscard]] MessageTree read_scalar(const wire::TypeDescription& type, wire::CdrCursor& cursor);

}  // namespace galilean::monitor
