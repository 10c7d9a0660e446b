// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/message_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/monitor/mcap/built_file.h"

namespace galilean::mcap {
namespace {

/// A source that counts the bytes that are read from it.
class CountingSource final : public ByteSource {
 public:
  explicit CountingSource(ByteView bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::span<std::uint8_t> to) const override {
    read_bytes += to.size();
    return bytes_.read(offset, to);
  }
  mutable std::uint64_t read_bytes = 0;

 private:
  MemorySource bytes_;
};

/// Chunks of random messages whose times overlap, and the messages in the order of the file.
struct Overlapping {
  BuiltFile file;
  std::vector<Small> messages;

  Overlapping(unsigned seed, bool with_loose) {
    std::mt19937 random(seed);
    for (const std::uint16_t id : {1, 2, 3}) file.channel(id);
    for (int chunk = 0; chunk < 40; ++chunk) {
      std::vector<Small> some(random() % 20);
      for (auto& each : some)
        each = {static_cast<std::uint16_t>(1 + random() % 3),
                1000u * static_cast<unsigned>(chunk) + random() % 5000,
                static_cast<std::uint8_t>(random())};
      messages.insert(messages.end(), some.begin(), some.end());
      if (with_loose && chunk % 3 == 0)
        for (const auto& each : some) file.loose(each);
      else
        file.chunk(some, {.compression = chunk % 2 ? "zstd" : ""});
    }
    file.close();
    std::ranges::stable_sort(messages, {}, &Small::log_ns);
  }
};

TEST(MessageReader, GivesLogTimeOrderAcrossChunksAndFileOrderWithinOneTime) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Overlapping recording(seed, seed % 2 == 0);
    EXPECT_EQ(read_messages(recording.file.bytes), recording.messages) << seed;
  }
}

TEST(MessageReader, GivesTheSameWhenItHasMemoryForOneChunkOnly) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Overlapping recording(seed, true);
    EXPECT_EQ(read_messages(recording.file.bytes, 1), recording.messages) << seed;
  }
}

TEST(MessageReader, ReadsAChunkTwiceAtMostIfEachHasAMessageStampedZero) {
  BuiltFile file;
  file.channel(1);
  constexpr int kChunks = 100, kMessages = 50;
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    std::vector<Small> messages{{1, 0, static_cast<std::uint8_t>(chunk)}};
    for (unsigned i = 0; i < kMessages; ++i)
      messages.push_back({1, 1'000'000u + static_cast<unsigned>(chunk) * 100u + i, 7});
    file.chunk(messages, {});
  }
  file.close();
  const Summary summary = summary_of(file.bytes);
  const CountingSource source(file.bytes);
  MessageReader reader(source, summary.blocks, 8000);  // about three chunks
  std::uint64_t before_ns = 0, count = 0;
  while (const Message* message = reader.next()) {
    EXPECT_LE(before_ns, message->log_ns);
    before_ns = message->log_ns;
    ++count;
  }
  EXPECT_EQ(count, std::uint64_t{kChunks} * (kMessages + 1));
  EXPECT_LE(source.read_bytes, 2 * file.bytes.size());
}

TEST(MessageReader, ReadsAFileInOrderOnce) {
  BuiltFile file;
  file.channel(1);
  for (unsigned chunk = 0; chunk < 20; ++chunk)
    file.chunk({{1, chunk * 10, 1}, {1, chunk * 10 + 5, 2}}, {});
  file.close();
  const Summary summary = summary_of(file.bytes);
  const CountingSource source(file.bytes);
  MessageReader reader(source, summary.blocks);
  while (reader.next()) {
  }
  EXPECT_LE(source.read_bytes, file.bytes.size());
}

TEST(MessageReader, MessagesOutsideChunksAreSortedToo) {
  BuiltFile file;
  file.channel(1).loose({1, 30, 3}).loose({1, 10, 1}).channel(2).loose({2, 20, 2}).close();
  EXPECT_EQ(read_messages(file.bytes), (std::vector<Small>{{1, 10, 1}, {2, 20, 2}, {1, 30, 3}}));
}

}  // namespace
}  // namespace galilean::mcap
