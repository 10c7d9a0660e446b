// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

struct ZSTD_CCtx_s;

namespace galilean::robot {

/// Packs pictures without loss: the difference of each byte to the one of the same colour to its
/// left, in zstd. It keeps its working memory.
class PicturePacker {
 public:
  PicturePacker();
  ~PicturePacker();
  PicturePacker(const PicturePacker&) = delete;
  PicturePacker& operator=(const PicturePacker&) = delete;

  /// Errors: throws std::runtime_error if zstd refuses.
  void pack(std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& to);
  /// Packs bytes that are no picture. Errors: as for pack.
  void pack_bytes(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& to);

 private:
  ZSTD_CCtx_s* context_;
  std::vector<std::uint8_t> differences_;
};

/// Returns false if `packed` is damaged or does not hold exactly `rgb.size()` bytes.
[[nodiscard]] bool unpack(std::span<const std::uint8_t> packed, std::span<std::uint8_t> rgb);
[[nodiscard]] bool unpack_bytes(std::span<const std::uint8_t> packed,
                                std::span<std::uint8_t> bytes);

}  // namespace galilean::robot
