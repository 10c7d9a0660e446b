// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/lz4.h"

#include <lz4frame.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace galilean::mcap {
namespace {

struct FreeLz4Context {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

std::unique_ptr<LZ4F_dctx, FreeLz4Context> new_lz4_context() {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) throw std::bad_alloc();
  return std::unique_ptr<LZ4F_dctx, FreeLz4Context>(context);
}

}  // namespace

bool decompress_lz4(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to) {
  const auto context = new_lz4_context();
  std::size_t expected = 1;  // LZ4F's hint of the bytes still to come; 0 at the end of the frame
  while (expected != 0 && !frame.empty()) {
    std::size_t filled = to.size(), taken = frame.size();
    expected = LZ4F_decompress(context.get(), to.data(), &filled, frame.data(), &taken, nullptr);
    if (LZ4F_isError(expected) || (filled == 0 && taken == 0)) return false;
    to = to.subspan(filled);
    frame = frame.subspan(taken);
  }
  return expected == 0 && to.empty();
}

void compress_lz4(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& frame) {
  frame.resize(LZ4F_compressFrameBound(bytes.size(), nullptr));
  const std::size_t size =
      LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size)) throw std::runtime_error(LZ4F_getErrorName(size));
  frame.resize(size);
}

}  // namespace galilean::mcap
