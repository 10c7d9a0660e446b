// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/cdr_cursor.h"

#include <bit>

namespace galilean::wire {
namespace {

constexpr std::size_t kHeader = 4;
// The second byte of the header (DDSI-RTPS 2.3, 10.2.1.2); those of little endian are odd.
constexpr std::uint8_t kLastOfFirst = 3;
constexpr std::uint8_t kBeginOfSecond = 6, kLastOfSecond = 11;

}  // namespace

CdrCursor::CdrCursor(std::span<const std::uint8_t> message) noexcept
    : message_(message), at_(kHeader), end_(message.size()), origin_(kHeader) {
  if (message.size() < kHeader || message[0] != 0) return;
  const std::uint8_t encoding = message[1];
  second_ = encoding >= kBeginOfSecond && encoding <= kLastOfSecond;
  ok_ = second_ || encoding <= kLastOfFirst;
  swap_ = (encoding % 2 == 1) != (std::endian::native == std::endian::little);
}

void CdrCursor::align(std::size_t size) noexcept {
  const std::size_t step = second_ ? std::min<std::size_t>(size, 4) : size;
  at_ = origin_ + (at_ - origin_ + step - 1) / step * step;
}

bool CdrCursor::has(std::size_t size) noexcept {
  if (at_ > end_ || end_ - at_ < size) ok_ = false;
  return ok_;
}

std::span<const std::uint8_t> CdrCursor::read_bytes(std::size_t count) noexcept {
  if (!has(count)) return {};
  const auto bytes = message_.subspan(at_, count);
  at_ += count;
  return bytes;
}

std::string_view CdrCursor::read_text() noexcept {
  const auto bytes = read_bytes(read<std::uint32_t>());
  if (bytes.empty()) return {};
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size() - 1};
}

CdrCursor::Whole CdrCursor::enter(std::size_t size, bool own_origin) noexcept {
  if (!has(size)) return {end_, origin_, at_};
  const Whole whole{end_, origin_, at_ + size};
  end_ = whole.next;
  if (own_origin) origin_ = at_;
  return whole;
}

void CdrCursor::leave(const Whole& whole) noexcept {
  at_ = whole.next;
  end_ = whole.end;
  origin_ = whole.origin;
}

}  // namespace galilean::wire
