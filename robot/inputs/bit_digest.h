// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include "core/clock.h"
#include "core/geometry.h"

namespace galilean::robot {

/// A 64-bit digest of exact bits, eight bytes at a time: a tick makes it of all that it led to.
/// Zero and minus zero differ, and so do two kinds of NaN. It is the same on every machine. It
/// finds what differs by chance, and is no protection against forgery.
class BitDigest {
 public:
  void add(std::uint64_t bits) noexcept { value_ = mixed(value_, bits); }
  void add(std::int64_t number) noexcept { add(static_cast<std::uint64_t>(number)); }
  template <std::unsigned_integral T>
  void add(T number) noexcept {
    add(std::uint64_t{number});
  }
  void add(double number) noexcept { add(std::bit_cast<std::uint64_t>(number)); }
  void add(Time time) noexcept { add(std::int64_t{time.time_since_epoch().count()}); }
  void add(const Vec2& vector) noexcept {
    add(vector.x());
    add(vector.y());
  }
  void add(std::string_view text) noexcept {
    add(text.size());
    for (const char c : text) add(static_cast<std::uint8_t>(c));
  }
  /// Adds pixels. Four lanes are mixed side by side, because one would wait for each
  /// multiplication.
  void add(std::span<const std::uint8_t> bytes) noexcept {
    constexpr std::size_t kLanes = 4, kStep = kLanes * sizeof(std::uint64_t);
    std::array<std::uint64_t, kLanes> lanes{1, 2, 3, 4};
    std::size_t at = 0;
    for (; at + kStep <= bytes.size(); at += kStep)
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        lanes[lane] = mixed(lanes[lane], word(bytes.data() + at + lane * sizeof(std::uint64_t)));
    for (const std::uint64_t lane : lanes) add(lane);
    for (; at < bytes.size(); ++at) add(bytes[at]);
    add(bytes.size());
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return value_ ^ value_ >> 32; }

 private:
  static std::uint64_t mixed(std::uint64_t value, std::uint64_t bits) noexcept {
    return std::rotl(value ^ bits * 0x9e3779b97f4a7c15, 29) * 0xbf58476d1ce4e5b9;
  }
  static std::uint64_t word(const std::uint8_t* bytes) noexcept {
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t read = 0;
    std::memcpy(&read, bytes, sizeof read);
    return read;
  }

  std::uint64_t value_ = 0x9e3779b97f4a7c15;
};

}  // namespace galilean::robot
