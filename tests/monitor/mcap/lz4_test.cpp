// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/lz4.h"

#include <gtest/gtest.h>
#include <lz4frame.h>

#include "tests/monitor/mcap/built_file.h"

namespace galilean::mcap {
namespace {

Bytes frame_of(const Bytes& bytes) {
  Bytes frame(LZ4F_compressFrameBound(bytes.size(), nullptr));
  frame.resize(LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), nullptr));
  return frame;
}

Bytes some_bytes(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * i >> 7);
  return bytes;
}

TEST(Lz4, GivesBackWhatWasCompressed) {
  for (const std::size_t size : {0u, 1u, 1000u, 3'000'000u}) {
    const Bytes bytes = some_bytes(size);
    Bytes back(size);
    EXPECT_TRUE(decompress_lz4(frame_of(bytes), back)) << size;
    EXPECT_EQ(back, bytes);
  }
}

TEST(Lz4, RefusesWhatDoesNotFillTheSizeOrIsCut) {
  const Bytes bytes = some_bytes(5000), frame = frame_of(bytes);
  Bytes larger(5001), smaller(4999), same(5000);
  EXPECT_FALSE(decompress_lz4(frame, larger));
  EXPECT_FALSE(decompress_lz4(frame, smaller));
  for (std::size_t size = 0; size < frame.size(); ++size)
    EXPECT_FALSE(decompress_lz4(ByteView(frame).first(size), same)) << size;
}

TEST(Lz4, ChunksOfEveryCompressionAreRead) {
  BuiltFile file;
  file.channel(1);
  file.chunk({{1, 10, 1}, {1, 20, 2}}, {.compression = "lz4"});
  file.chunk({{1, 30, 3}}, {.compression = "zstd"});
  file.chunk({{1, 40, 4}}, {.compression = ""});
  file.close();
  EXPECT_EQ(read_messages(file.bytes),
            (std::vector<Small>{{1, 10, 1}, {1, 20, 2}, {1, 30, 3}, {1, 40, 4}}));
  const Summary summary = summary_of(file.bytes);
  EXPECT_FALSE(summary.recovered());
  EXPECT_EQ(summary.compressions,
            (std::map<std::string, std::uint32_t>{{"", 1}, {"lz4", 1}, {"zstd", 1}}));
}

TEST(Lz4, AnUnknownCompressionIsNamedWithWhatItHides) {
  BuiltFile file;
  file.channel(1);
  file.chunk({{1, 10, 1}, {1, 20, 2}}, {.compression = "brotli"});
  file.close();
  const Summary summary = summary_of(file.bytes);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_NE(summary.damages[0].what.find("compressed by 'brotli', which is not read here"),
            std::string::npos);
  EXPECT_EQ(summary.damages[0].messages, 2u);
}

}  // namespace
}  // namespace galilean::mcap
