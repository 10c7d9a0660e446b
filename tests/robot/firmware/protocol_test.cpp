// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/protocol.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "robot/firmware/crc.h"
#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Message {
  std::uint8_t type;
  std::uint16_t sequence;
  Bytes payload;
  bool operator==(const Message&) const = default;
};

Bytes encoded(const Message& message) {
  std::array<std::uint8_t, kMaxEncoded> out;
  const auto size = encode({message.type, message.sequence, message.payload}, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

std::vector<Message> decode(FrameDecoder& decoder, const Bytes& bytes) {
  std::vector<Message> messages;
  for (const auto byte : bytes)
    if (decoder.push(byte)) {
      const Frame& frame = decoder.frame();
      messages.push_back(
          {frame.type, frame.sequence, Bytes(frame.payload.begin(), frame.payload.end())});
    }
  return messages;
}

class Generator {
 public:
  explicit Generator(unsigned seed) : engine_(seed) {}
  int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(4) == 0 ? 0 : below(256)); }
  Bytes bytes(int count) {
    Bytes result;
    for (int i = 0; i < count; ++i) result.push_back(byte());
    return result;
  }
  Message message() {
    return {byte(), static_cast<std::uint16_t>(below(65536)), bytes(below(kMaxPayload + 1))};
  }

 private:
  std::mt19937 engine_;
};

TEST(Crc, HasThePublishedCheckValue) {
  const std::string_view digits = "123456789";
  EXPECT_EQ(crc16(std::span(reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size())),
            0x29B1);
}

TEST(Protocol, EveryMessageComesBackAsItWas) {
  Generator random(1);
  FrameDecoder decoder;
  for (int i = 0; i < 20000; ++i) {
    const Message sent = random.message();
    EXPECT_EQ(decode(decoder, encoded(sent)), std::vector{sent});
  }
  EXPECT_EQ(decoder.rejected(), 0u);
}

TEST(Protocol, ZerosStandOnlyAtTheEndsOfAFrame) {
  Generator random(2);
  for (int i = 0; i < 2000; ++i) {
    const Bytes frame = encoded(random.message());
    EXPECT_EQ(std::count(frame.begin(), frame.end(), 0), 2);
    EXPECT_EQ(frame.front(), 0);
    EXPECT_EQ(frame.back(), 0);
  }
}

TEST(Protocol, NoiseBetweenFramesCostsNoFrame) {
  Generator random(3);
  FrameDecoder decoder;
  for (int i = 0; i < 20000; ++i) {
    const Message sent = random.message();
    Bytes line = random.bytes(random.below(100));
    const Bytes frame = encoded(sent);
    line.insert(line.end(), frame.begin(), frame.end());
    EXPECT_EQ(decode(decoder, line), std::vector{sent});
  }
  EXPECT_GT(decoder.rejected(), 0u);
}

TEST(Protocol, DamagedFramesAreNeverTakenAndTheNextOneAlwaysIs) {
  Generator random(4);
  FrameDecoder decoder;
  for (int i = 0; i < 40000; ++i) {
    const Message lost = random.message();
    const Message next = random.message();
    Bytes line = encoded(lost);
    const int damages = 1 + random.below(2);
    for (int n = 0; n < damages; ++n) {
      const auto at = 1 + random.below(static_cast<int>(line.size()) - 2);
      line[static_cast<std::size_t>(at)] ^= static_cast<std::uint8_t>(1 << random.below(8));
    }
    const bool unharmed = line == encoded(lost);
    const Bytes good = encoded(next);
    line.insert(line.end(), good.begin(), good.end());
    const auto messages = decode(decoder, line);
    ASSERT_FALSE(messages.empty());
    EXPECT_EQ(messages.back(), next);
    EXPECT_EQ(messages.size(), unharmed ? 2u : 1u);
  }
}

TEST(Protocol, BytesLostOrDoubledAreNeverTaken) {
  Generator random(5);
  FrameDecoder decoder;
  for (int i = 0; i < 40000; ++i) {
    const Message sent = random.message();
    Bytes line = encoded(sent);
    const auto at = line.begin() + 1 + random.below(static_cast<int>(line.size()) - 2);
    if (random.below(2))
      line.erase(at);
    else
      line.insert(at, random.byte());
    for (const Message& taken : decode(decoder, line)) EXPECT_EQ(taken, sent);
  }
}

TEST(Protocol, EndlessGarbageNeitherFillsUpNorHarms) {
  FrameDecoder decoder;
  for (int i = 0; i < 100000; ++i) EXPECT_FALSE(decoder.push(0xFF));
  const Message sent{3, 7, {1, 2, 3}};
  EXPECT_EQ(decode(decoder, encoded(sent)), std::vector{sent});
}

TEST(Protocol, APayloadThatIsTooLongIsNotSent) {
  std::array<std::uint8_t, kMaxEncoded> out;
  EXPECT_EQ(encode({1, 1, Bytes(kMaxPayload + 1)}, out), 0u);
}

}  // namespace
}  // namespace galilean::robot::firmware
