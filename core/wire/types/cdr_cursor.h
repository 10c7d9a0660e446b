// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace galilean::wire {

/// Walks through an encoded message of any type, in CDR of version 1 or 2 (XTypes 1.3, 7.4) and in
/// either byte order. It never reads outside of the message, nor outside of the part that it is in:
/// it then is no longer ok, and whatever it reads is zero or empty.
class CdrCursor {
 public:
  /// `message` begins with the header of four bytes, and outlives this.
  explicit CdrCursor(std::span<const std::uint8_t> message) noexcept;

  [[nodiscard]] bool ok() const noexcept { return ok_; }
  void fail() noexcept { ok_ = false; }
  /// Returns whether it is version 2.
  [[nodiscard]] bool is_second() const noexcept { return second_; }
  /// Returns how many bytes of the present part were not read yet.
  [[nodiscard]] std::size_t left() const noexcept { return ok_ && at_ < end_ ? end_ - at_ : 0; }

  template <std::integral Number>
  Number read() noexcept {
    align(sizeof(Number));
    Number number = 0;
    const auto bytes = read_bytes(sizeof(Number));
    if (bytes.empty()) return number;
    std::array<std::uint8_t, sizeof(Number)> own;
    std::ranges::copy(bytes, own.begin());
    if (swap_) std::ranges::reverse(own);
    std::memcpy(&number, own.data(), sizeof(Number));
    return number;
  }
  /// Returns what read returns, and stays before it.
  template <std::integral Number>
  Number peek() noexcept {
    const std::size_t before = at_;
    const auto number = read<Number>();
    at_ = before;
    return number;
  }
  /// Returns the next bytes, or none if there are not so many.
  std::span<const std::uint8_t> read_bytes(std::size_t count) noexcept;
  /// Returns a text without the zero at its end.
  std::string_view read_text() noexcept;
  /// Skips what stands before a value of that size.
  void align(std::size_t size) noexcept;

  /// What leave needs to go back to the whole that a part is in.
  struct Whole {
    std::size_t end, origin, next;
  };
  /// Enters the next `size` bytes. With `own_origin`, values in it are aligned to its beginning.
  [[nodiscard]] Whole enter(std::size_t size, bool own_origin = false) noexcept;
  /// Goes to behind the part, wherever in it this is.
  void leave(const Whole& whole) noexcept;

 private:
  [[nodiscard]] bool has(std::size_t size) noexcept;

  std::span<const std::uint8_t> message_;
  std::size_t at_ = 0, end_ = 0, origin_ = 0;
  bool ok_ = false, swap_ = false, second_ = false;
};

}  // namespace galilean::wire
