// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/byte_source.h"

namespace galilean::mcap {

/// Reads small pieces of a file without a system call for each. It sees the file as long as it was
/// when the window was made.
class ByteWindow {
 public:
  explicit ByteWindow(const ByteSource& source) : source_(source), end_(source.size()) {}

  /// Returns the size of the file [bytes].
  [[nodiscard]] std::uint64_t end() const noexcept { return end_; }
  /// Returns the bytes from `offset` on, `size` of them or as many as the file has; none if the
  /// disk fails. They are valid until the next call.
  [[nodiscard]] std::span<const std::uint8_t> at(std::uint64_t offset, std::size_t size);

 private:
  const ByteSource& source_;
  std::uint64_t end_, start_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace galilean::mcap
