// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/zstd.h"

#include <zstd.h>

#include <new>
#include <stdexcept>

namespace galilean::mcap {
namespace {
constexpr int kFastLevel = 1, kSmallLevel = 9;
}

Compressor::Compressor(Compression compression)
    : compression_(compression), context_(ZSTD_createCCtx()) {
  if (!context_) throw std::bad_alloc();
}

Compressor::~Compressor() {
  ZSTD_freeCCtx(context_);
}

std::span<const std::uint8_t> Compressor::compress(std::span<const std::uint8_t> bytes) {
  if (compression_ == Compression::kNone) return bytes;
  frame_.resize(ZSTD_compressBound(bytes.size()));
  const int level = compression_ == Compression::kSmall ? kSmallLevel : kFastLevel;
  const std::size_t size =
      ZSTD_compressCCtx(context_, frame_.data(), frame_.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  return {frame_.data(), size};
}

bool decompress(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to) {
  const std::size_t size = ZSTD_decompress(to.data(), to.size(), frame.data(), frame.size());
  return !ZSTD_isError(size) && size == to.size();
}

}  // namespace galilean::mcap
