// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/picture_packing.h"

#include <zstd.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace galilean::robot {
namespace {

constexpr std::size_t kColours = 3;
constexpr int kLevel = 1;  // higher levels take several times as long to save a few percent

}  // namespace

PicturePacker::PicturePacker() : context_(ZSTD_createCCtx()) {}

PicturePacker::~PicturePacker() {
  ZSTD_freeCCtx(context_);
}

void PicturePacker::pack(std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& to) {
  differences_.resize(rgb.size());
  for (std::size_t i = 0; i < rgb.size(); ++i)
    differences_[i] = static_cast<std::uint8_t>(rgb[i] - (i < kColours ? 0 : rgb[i - kColours]));
  pack_bytes(differences_, to);
}

void PicturePacker::pack_bytes(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& to) {
  to.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compressCCtx(context_, to.data(), to.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size))
    throw std::runtime_error(std::string("inputs cannot be packed: ") + ZSTD_getErrorName(size));
  to.resize(size);
}

bool unpack_bytes(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes) {
  const std::size_t size =
      ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  return !ZSTD_isError(size) && size == bytes.size();
}

bool unpack(std::span<const std::uint8_t> packed, std::span<std::uint8_t> rgb) {
  if (!unpack_bytes(packed, rgb)) return false;
  for (std::size_t i = kColours; i < rgb.size(); ++i)
    rgb[i] = static_cast<std::uint8_t>(rgb[i] + rgb[i - kColours]);
  return true;
}

}  // namespace galilean::robot
