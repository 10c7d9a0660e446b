// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/crc.h"

#include <array>

namespace galilean::robot::firmware {
namespace {

constexpr std::uint16_t kPolynomial = 0x1021;

constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    auto remainder = static_cast<std::uint16_t>(byte << 8);
    for (int bit = 0; bit < 8; ++bit)
      remainder =
          static_cast<std::uint16_t>((remainder << 1) ^ ((remainder & 0x8000) ? kPolynomial : 0));
    table[byte] = remainder;
  }
  return table;
}

constexpr auto kTable = make_table();

}  // namespace

std::uint16_t crc16(std::span<const std::uint8_t> bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes)
    crc = static_cast<std::uint16_t>((crc << 8) ^ kTable[(crc >> 8) ^ byte]);
  return crc;
}

}  // namespace galilean::robot::firmware
