// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace galilean::mcap {

/// Returns the CRC-32 of zlib, PNG and MCAP (polynomial 0x04c11db7 reflected, initial and final XOR
/// all ones). `so_far` is the checksum of the bytes before, so that a stream can be summed piece by
/// piece.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes,
                                  std::uint32_t so_far = 0) noexcept;

}  // namespace galilean::mcap
