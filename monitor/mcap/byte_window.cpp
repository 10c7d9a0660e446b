// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/byte_window.h"

#include <algorithm>

namespace galilean::mcap {
namespace {
/// Large enough for the heads of many small records, small beside a chunk that is passed over.
constexpr std::size_t kWindowBytes = 8192;
}  // namespace

std::span<const std::uint8_t> ByteWindow::at(std::uint64_t offset, std::size_t size) {
  if (offset >= end_) return {};
  size = static_cast<std::size_t>(std::min<std::uint64_t>(size, end_ - offset));
  if (offset < start_ || offset + size > start_ + bytes_.size()) {
    const auto wanted = std::max(size, kWindowBytes);
    bytes_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(wanted, end_ - offset)));
    start_ = offset;
    if (!source_.read(offset, bytes_)) bytes_.clear();
  }
  if (bytes_.empty()) return {};
  return std::span(bytes_).subspan(static_cast<std::size_t>(offset - start_), size);
}

}  // namespace galilean::mcap
