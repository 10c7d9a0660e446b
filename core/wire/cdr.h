// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace galilean::msg {

/// Reads plain CDR (XCDR1, either byte order) with its four-byte header, as DDS, MCAP files and
/// browsers carry it. It never reads past the end. If a message is cut short, `ok` becomes false
/// and the missing fields are zero or empty.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    ok_ = bytes.size() >= 4 && bytes[0] == 0 && bytes[1] <= 1;
    swap_ = ok_ && bytes[1] == 0;
    at_ = 4;
  }

  [[nodiscard]] bool ok() const noexcept { return ok_; }

  template <class T>
  requires std::is_arithmetic_v<T>
  void read(T& to) {
    align(sizeof(T));
    to = T{};
    if (!has(sizeof(T))) return;
    std::uint8_t raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i)
      raw[swap_ ? sizeof(T) - 1 - i : i] = bytes_[at_ + i];
    if constexpr (std::is_same_v<T, bool>)
      to = raw[0] != 0;
    else
      std::memcpy(&to, raw, sizeof(T));
    at_ += sizeof(T);
  }
  void read(std::string& to) {
    std::uint32_t size = 0;
    read(size);
    to.clear();
    if (size == 0 || !has(size)) return;
    to.assign(reinterpret_cast<const char*>(bytes_.data() + at_), size - 1);
    at_ += size;
  }
  /// Reads a string without a copy. It is valid as long as the bytes.
  void read(std::string_view& to) {
    std::uint32_t size = 0;
    read(size);
    to = {};
    if (size == 0 || !has(size)) return;
    to = {reinterpret_cast<const char*>(bytes_.data() + at_), size - 1};
    at_ += size;
  }
  /// Leaves out `count` numbers, each of `size` bytes.
  void skip(std::size_t count, std::size_t size) {
    if (count == 0) return;
    align(size);
    if (has(0) && (bytes_.size() - at_) / size >= count)
      at_ += count * size;
    else
      ok_ = false;
  }
  template <class T>
  void read(std::vector<T>& to) {
    std::uint32_t count = 0;
    read(count);
    to.clear();
    if (!has(count)) return;  // an element takes at least one byte
    if constexpr (sizeof(T) == 1 && !std::is_same_v<T, bool>) {
      const auto* first = reinterpret_cast<const T*>(bytes_.data() + at_);
      to.assign(first, first + count);
      at_ += count;
    } else {
      for (std::uint32_t i = 0; i < count && ok_; ++i) read(to.emplace_back());
    }
  }
  template <class T, std::size_t N>
  void read(std::array<T, N>& to) {
    for (auto& item : to) read(item);
  }
  template <class M>
  requires std::is_class_v<M>
  void read(M& to) { decode(*this, to); }
  /// Returns whether the message ends here. Up to three bytes of padding may stand at its end.
  [[nodiscard]] bool ends() {
    constexpr std::size_t kWord = 4;
    align(kWord);
    return ok_ && at_ >= bytes_.size();
  }
  /// Reads a field that was appended to its message in a later release. It is left as it is if the
  /// message ends before it.
  template <class M>
  void read_appended(M& to) {
    if (!ends()) read(to);
  }

 private:
  void align(std::size_t size) { at_ = 4 + (at_ - 4 + size - 1) / size * size; }
  bool has(std::size_t size) {
    if (!ok_ || at_ > bytes_.size() || bytes_.size() - at_ < size) ok_ = false;
    return ok_;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool ok_ = false;
  bool swap_ = false;
};

/// Decodes `bytes` into `message`. Returns false if they are not a whole message of this type.
template <class M>
[[nodiscard]] bool decode_cdr(std::span<const std::uint8_t> bytes, M& message) {
  CdrReader reader(bytes);
  decode(reader, message);
  return reader.ok();
}

}  // namespace galilean::msg
