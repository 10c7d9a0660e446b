// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "monitor/mcap/byte_sink.h"

namespace galilean::mcap {

/// A disk that takes bytes until it is full. The write that does not fit is cut short and fails, as
/// on a real disk.
class FaultyDisk final : public ByteSink {
 public:
  explicit FaultyDisk(std::size_t capacity = SIZE_MAX) : capacity_(capacity) {}
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    const std::size_t fitting = std::min(bytes.size(), capacity_ - bytes_.size());
    bytes_.insert(bytes_.end(), bytes.begin(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(fitting));
    if (fitting == bytes.size()) return {};
    return Error{"the disk is full"};
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return bytes_; }

 private:
  std::size_t capacity_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace galilean::mcap
