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
  return {0,    1,    0,    0,                     // header: plain CDR, little-endian
          7,    0,    0,    0,    9,   0,   0, 0,  // stamp
          3,    0,    0,    0,    'i', 'd', 0,     // id
          0,                                       // padding
          1,    0,    0,    0,    0,               // author: empty
          0,    0,    0,                           // padding
          1,    0,    0,    0,                     // one target
          3,    0,    0,    0,    'i', 'o', 0,     //
          2,                                       // kind: in the gap, for it needs no alignment
          0xfe, 0xff, 0xff, 0xff,                  // argument: -2
          1,    0,    0,    0,    0,               // signature.key_id: empty
          0,    0,    0,                           // padding
          5,    0,    0,    0,    0,   0,   0, 0,  // signature.number
          6,    0,    0,    0,    0,   0,   0, 0,  // signature.issued_ns
          7,    0,    0,    0,    0,   0,   0, 0,  // signature.expires_ns
          0,    0,    0,    0};                    // signature.bytes: none
}
/// Where the fields end that an earlier release knew, with the header.
constexpr std::size_t kWithoutSignature = 44;

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
  EXPECT_EQ(command.signature.number, 5U);
  EXPECT_EQ(command.signature.issued_ns, 6);
  EXPECT_EQ(command.signature.expires_ns, 7);
}

TEST(CdrWriter, WritesWhatTheReaderReads) {
  Command command;
  ASSERT_TRUE(decode_cdr(command_bytes(), command));
  EXPECT_EQ(encode_cdr(command), command_bytes());
  Variables variables;
  variables.robot = "io";
  variables.tick = 1;
  variables.items = {
      {"trash", Variable_Constants::LOCATE, "trash", true, 0.5F, 0.1F, {1, 2}, {1.5}},
      {"bumpers", Variable_Constants::BITS, "", false, 0, 0, {}, {}}};
  Variables again;
  ASSERT_TRUE(decode_cdr(encode_cdr(variables), again));
  EXPECT_EQ(again, variables);
  Odometry odometry;
  odometry.pose.covariance[35] = 0.25;
  Odometry odometry_again;
  ASSERT_TRUE(decode_cdr(encode_cdr(odometry), odometry_again));
  EXPECT_EQ(odometry_again, odometry);
}

TEST(CdrReader, ReadsOrdersOfReleasesThatKnewNoSignature) {
  Command whole;
  ASSERT_TRUE(decode_cdr(command_bytes(), whole));
  whole.signature = {};
  Bytes old = command_bytes();
  old.resize(kWithoutSignature);
  Command command;
  ASSERT_TRUE(decode_cdr(old, command));
  EXPECT_EQ(command, whole);
  // The break points' kinds end such an order between two words.
  BreakOrder order;
  order.points = {{"", "grab", 1}};
  constexpr std::size_t kEnd = 4 + 58;  // the header, and all fields to the point's kind
  for (std::size_t padding = 0; padding <= 2; ++padding) {
    Bytes bytes = encode_cdr(order);
    bytes.resize(kEnd + padding);
    BreakOrder again;
    ASSERT_TRUE(decode_cdr(bytes, again)) << padding;
    EXPECT_EQ(again, order);
  }
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
    if (size == kWithoutSignature) continue;  // that is a whole one of an earlier release
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
    survive<BreakOrder>(bytes);
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
