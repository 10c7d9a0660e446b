// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace galilean::robot::firmware {

/// A message lists its fields once, in `static void fields(Self&, Io&)`; these three walk that
/// list. All numbers travel little-endian, float as IEEE 754 single.

class PayloadSize {
 public:
  template <class T>
  constexpr void operator()(const T&) {
    bytes_ += sizeof(T);
  }
  constexpr std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

class PayloadWriter {
 public:
  explicit PayloadWriter(std::span<std::uint8_t> out) : out_(out) {}

  void operator()(std::uint8_t value) { out_[at_++] = value; }
  void operator()(std::uint16_t value) { low_bytes(value, 2); }
  void operator()(std::int16_t value) { low_bytes(static_cast<std::uint16_t>(value), 2); }
  void operator()(std::uint32_t value) { low_bytes(value, 4); }
  void operator()(std::int32_t value) { low_bytes(static_cast<std::uint32_t>(value), 4); }
  void operator()(float value) { low_bytes(std::bit_cast<std::uint32_t>(value), 4); }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& values) {
    for (const T& value : values) (*this)(value);
  }

 private:
  void low_bytes(std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) out_[at_++] = static_cast<std::uint8_t>(value >> (8 * i));
  }

  std::span<std::uint8_t> out_;
  std::size_t at_ = 0;
};

class PayloadReader {
 public:
  explicit PayloadReader(std::span<const std::uint8_t> in) : in_(in) {}

  void operator()(std::uint8_t& value) { value = in_[at_++]; }
  void operator()(std::uint16_t& value) { value = static_cast<std::uint16_t>(low_bytes(2)); }
  void operator()(std::int16_t& value) { value = static_cast<std::int16_t>(low_bytes(2)); }
  void operator()(std::uint32_t& value) { value = low_bytes(4); }
  void operator()(std::int32_t& value) { value = static_cast<std::int32_t>(low_bytes(4)); }
  void operator()(float& value) { value = std::bit_cast<float>(low_bytes(4)); }
  template <class T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }

 private:
  std::uint32_t low_bytes(int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value |= static_cast<std::uint32_t>(in_[at_++]) << (8 * i);
    return value;
  }

  std::span<const std::uint8_t> in_;
  std::size_t at_ = 0;
};

template <class Message>
constexpr std::size_t payload_size() {
  const Message message{};
  PayloadSize size;
  Message::fields(message, size);
  return size.bytes();
}

}  // namespace galilean::robot::firmware
