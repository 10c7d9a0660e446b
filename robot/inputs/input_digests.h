// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "core/wire/messages.h"

namespace galilean::robot {

// Digests of the inputs of a tick, one for each field of that name. They are made where the tick
// was handed over and compared where it is run again: a bit that changed between shows where it
// did.

[[nodiscard]] std::uint64_t orders_digest(const msg::TickInputs& inputs);
[[nodiscard]] std::uint64_t board_digest(const msg::TickInputs& inputs);
/// `pixels` is the digest of the newest picture, also where the message does not repeat it.
[[nodiscard]] std::uint64_t picture_digest(const msg::TickInputs& inputs, std::uint64_t pixels);
/// `words` are those that are packed in it.
[[nodiscard]] std::uint64_t memory_digest(const msg::ExecutiveMemory& memory,
                                          std::span<const std::uint64_t> words);
[[nodiscard]] std::uint64_t pixels_digest(std::span<const std::uint8_t> rgb);

}  // namespace galilean::robot
