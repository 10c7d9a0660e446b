// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace galilean::msg {

/// Writes plain CDR (XCDR1, little-endian) with its four-byte header. It writes the bytes that
/// Cyclone writes on a little-endian machine, but for padding at the end of a message.
class CdrWriter {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void write(T from) {
    align(sizeof(T));
    std::array<std::uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), &from, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bytes_.push_back(raw[std::endian::native == std::endian::big ? sizeof(T) - 1 - i : i]);
  }
  void write(const std::string& from) {
    write(static_cast<std::uint32_t>(from.size() + 1));
    bytes_.insert(bytes_.end(), from.begin(), from.end());
    bytes_.push_back(0);
  }
  template <class T>
  void write(const std::vector<T>& from) {
    write(static_cast<std::uint32_t>(from.size()));
    for (const T& item : from) write(item);
  }
  template <class T, std::size_t N>
  void write(const std::array<T, N>& from) {
    for (const T& item : from) write(item);
  }
  template <class M>
  requires std::is_class_v<M>
  void write(const M& from) { encode(*this, from); }

  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void align(std::size_t size) {
    while ((bytes_.size() - kHeaderBytes) % size != 0) bytes_.push_back(0);
  }

  static constexpr std::size_t kHeaderBytes = 4;
  std::vector<std::uint8_t> bytes_ = {0, 1, 0, 0};
};

/// Returns the message as CDR bytes. Two equal messages give the same bytes on every machine.
template <class M>
[[nodiscard]] std::vector<std::uint8_t> encode_cdr(const M& message) {
  CdrWriter writer;
  encode(writer, message);
  return writer.take();
}

}  // namespace galilean::msg
