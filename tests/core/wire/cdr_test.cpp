// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/wire/messages.h"

namespace galilean::msg {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Little-endian CDR of a Command: what Cyclone writes, byte for byte.
Bytes command_bytes() {
  return {0,    1,    0,    0,                    // header: plain CDR, little-endian
          7,    0,    0,    0,   9,   0,   0, 0,  // stamp
          3,    0,    0,    0,   'i', 'd', 0,     // id
          0,                                      // padding
          1,    0,    0,    0,   0,               // author: empty
          0,    0,    0,                          // padding
          1,    0,    0,    0,                    // one target
          3,    0,    0,    0,   'i', 'o', 0,     //
          2,                                      // kind: in the gap, for it needs no alignment
          0xfe, 0xff, 0xff, 0xff};                // argument: -2
}

TEST(CdrReader, ReadsWhatStandsThere) {
  Command command;
  ASSERT_TRUE(decode_cdr(command_bytes(), command));
  EXPECT_EQ(command.stamp.sec, 7);
  EXPECT_EQ(command.stamp.nanosec, 9u);
  EXPECT_EQ(command.id, "id");
  EXPECT_EQ(command.author, "");
  EXPECT_EQ(command.targets, std::vector<std::string>{"io"});
  EXPECT_EQ(command.kind, Command_Constants::RESUME);
  EXPECT_EQ(command.argument, -2);
}

TEST(CdrReader, ReadsTheOtherByteOrder) {
  const Bytes big{0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 3};
  Time time;
  ASSERT_TRUE(decode_cdr(big, time));
  EXPECT_EQ(time.sec, 258);
  EXPECT_EQ(time.nanosec, 3u);
}

TEST(CdrReader, RefusesEveryMessageCutShort) {
  const Bytes whole = command_bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Command command;
    EXPECT_FALSE(decode_cdr(std::span(whole).first(size), command)) << size << " bytes";
  }
}

TEST(CdrReader, RefusesOtherEncodings) {
  for (const std::uint8_t encoding : {2, 3, 6, 7, 255}) {
    Bytes bytes = command_bytes();
    bytes[1] = encoding;
    Command command;
    EXPECT_FALSE(decode_cdr(bytes, command)) << int{encoding};
  }
}

TEST(CdrReader, RefusesCountsBeyondTheMessage) {
  const Bytes bytes{0, 1, 0, 0, 0xff, 0xff, 0xff, 0xff, 1, 2, 3, 4};
  MarkerArray markers;
  EXPECT_FALSE(decode_cdr(bytes, markers));
  TFMessage transforms;
  EXPECT_FALSE(decode_cdr(bytes, transforms));
}

template <class M>
void survive(const Bytes& bytes) {
  M message;
  (void)decode_cdr(bytes, message);
}

TEST(CdrReader, SurvivesBytesOfAnyKind) {
  std::mt19937 random(94);
  for (int round = 0; round < 20000; ++round) {
    Bytes bytes = round % 2 ? command_bytes() : Bytes(random() % 200);
    const auto changes = bytes.empty() ? 0 : 1 + random() % 20;
    for (unsigned i = 0; i < changes; ++i)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (bytes.size() > 1) bytes[0] = 0, bytes[1] = round % 3 == 0;
    survive<Command>(bytes);
    survive<RobotState>(bytes);
    survive<Variables>(bytes);
    survive<MarkerArray>(bytes);
    survive<OccupancyGrid>(bytes);
    survive<Program>(bytes);
    survive<CompressedImage>(bytes);
  }
}

}  // namespace
}  // namespace galilean::msg
