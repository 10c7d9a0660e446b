// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct ZSTD_CCtx_s;

namespace galilean::mcap {

/// How much time is spent to make a recording small.
enum class Compression {
  kNone,
  kFast,
  kSmall,  ///< takes five times as long as kFast to save a tenth on telemetry
  kLz4     ///< faster than kFast, and larger; not made by a Compressor
};

/// Compresses chunks with zstd, and keeps its working memory from one chunk to the next.
class Compressor {
 public:
  explicit Compressor(Compression compression);
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  /// Returns `bytes` as one zstd frame, valid until the next call; with kNone `bytes` themselves.
  [[nodiscard]] std::span<const std::uint8_t> compress(std::span<const std::uint8_t> bytes);

 private:
  Compression compression_;
  ZSTD_CCtx_s* context_;
  std::vector<std::uint8_t> frame_;
};

/// Decompresses `frame` into `to`. Returns false if `frame` is damaged or does not hold exactly
/// `to.size()` bytes.
[[nodiscard]] bool decompress(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to);

}  // namespace galilean::mcap
