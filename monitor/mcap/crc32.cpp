#include "monitor/mcap/crc32.h"

#include <array>
#include <bit>
#include <cstring>

namespace galilean::mcap {
namespace {

constexpr std::uint32_t kPolynomial = 0xedb88320;  // reflected
constexpr std::size_t kSlices = 8;
using Tables = std::array<std::array<std::uint32_t, 256>, kSlices>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? kPolynomial : 0);
    tables[0][byte] = value;
  }
  for (std::size_t slice = 1; slice < kSlices; ++slice)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[slice - 1][byte];
      tables[slice][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t so_far) noexcept {
  static_assert(std::endian::native == std::endian::little);
  std::uint32_t crc = ~so_far;
  // Eight bytes a step, each by the table of its distance from the end: the sum is linear.
  for (; bytes.size() >= kSlices; bytes = bytes.subspan(kSlices)) {
    std::array<std::uint8_t, kSlices> step;
    std::memcpy(step.data(), bytes.data(), kSlices);
    std::uint32_t low;
    std::memcpy(&low, step.data(), sizeof low);
    low ^= crc;
    std::memcpy(step.data(), &low, sizeof low);
    crc = 0;
    for (std::size_t i = 0; i < kSlices; ++i) crc ^= kTables[kSlices - 1 - i][step[i]];
  }
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ kTables[0][(crc ^ byte) & 0xff];
  return ~crc;
}

}  // namespace galilean::mcap
