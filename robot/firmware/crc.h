// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace galilean::robot::firmware {

/// CRC-16/IBM-3740 ("CCITT-FALSE"): polynomial 0x1021, start 0xFFFF, no reflection, no final
/// inversion. The check value of "123456789" is 0x29B1.
std::uint16_t crc16(std::span<const std::uint8_t> bytes);

}  // namespace galilean::robot::firmware
