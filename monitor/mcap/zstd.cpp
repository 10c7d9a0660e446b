// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/zstd.h"

#include <zstd.h>

#include <new>
#include <stdexcept>

namespace galilean::mcap {
namespace {
constexpr int kLevel =
    1;  // low, because higher levels take five times as long to save a tenth on telemetry
}

Compressor::Compressor() : context_(ZSTD_createCCtx()) {
  if (!context_) throw std::bad_alloc();
}

Compressor::~Compressor() {
  ZSTD_freeCCtx(context_);
}

std::span<const std::uint8_t> Compressor::compress(std::span<const std::uint8_t> bytes) {
  frame_.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compressCCtx(context_, frame_.data(), frame_.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  return {frame_.data(), size};
}

bool decompress(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to) {
  const std::size_t size = ZSTD_decompress(to.data(), to.size(), frame.data(), frame.size());
  return !ZSTD_isError(size) && size == to.size();
}

}  // namespace galilean::mcap
