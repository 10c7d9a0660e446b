// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

namespace galilean::msg {

/// Writes a message in little-endian CDR, field by field, for tests of those who read it.
class CdrBytes {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> CdrBytes& put(T value) {
    while ((bytes_.size() - kHeader) % sizeof(T) != 0) bytes_.push_back(0);
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.insert(bytes_.end(), raw, raw + sizeof(T));
    return *this;
  }
  CdrBytes& put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  CdrBytes& stamp(std::int32_t sec = 0, std::uint32_t nanosec = 0) { return put(sec).put(nanosec); }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return bytes_; }

 private:
  static constexpr std::size_t kHeader = 4;
  std::vector<std::uint8_t> bytes_{0, 1, 0, 0};
};

}  // namespace galilean::msg
