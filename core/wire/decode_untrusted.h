// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "core/wire/bounds.h"
#include "core/wire/cdr.h"

namespace galilean::wire {

/// Decodes a message that did not come through Reader::take of its own type: one of a topic that is
/// read as bytes, or of a file. Returns false if the bytes are not a whole message of this type
/// within its bounds; `message` may then be half filled.
template <class M>
[[nodiscard]] bool decode_untrusted(std::span<const std::uint8_t> cdr, M& message) {
  static const Bounds kBounds = bounds_of(M::kRosType);
  return kBounds && fault_of(kBounds, cdr).empty() && msg::decode_cdr(cdr, message);
}

}  // namespace galilean::wire
