// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>

#include "robot/firmware/controller.h"
#include "robot/firmware/messages.h"
#include "tests/robot/firmware/bench_board.h"

namespace galilean::robot::firmware {
namespace {

template <class Message>
std::string hex(const Message& message, std::uint16_t sequence) {
  std::array<std::uint8_t, kMaxEncoded> bytes;
  const auto size = encode_message(message, sequence, bytes);
  std::ostringstream text;
  for (std::size_t i = 0; i < size; ++i)
    text << (i ? " " : "") << std::hex << std::setw(2) << std::setfill('0') << int{bytes[i]};
  return text.str();
}

/// The page's examples: under each heading "### 0x01 Hello" the one block marked as hex.
std::map<std::string, std::string> examples() {
  std::ifstream page(GALILEAN_SOURCE_DIR "/docs/SERIAL_PROTOCOL.md");
  std::map<std::string, std::string> found;
  std::string heading;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("### "))
      heading = line.substr(4);
    else if (line == "```hex")
      inside = true;
    else if (line == "```")
      inside = false;
    else if (inside)
      found[heading] += (found[heading].empty() ? "" : " ") + line;
  }
  return found;
}

std::array<std::uint8_t, 16> name(std::string_view text) {
  std::array<std::uint8_t, 16> bytes{};
  std::copy(text.begin(), text.end(), bytes.begin());
  return bytes;
}

Status status() {
  Status s;
  s.uptime_ms = 61020;
  s.boot_count = 7;
  s.last_command = 259;
  s.left_encoder_counts = 5200;
  s.right_encoder_counts = -16;
  s.left_speed_counts_s = 1600;
  s.right_speed_counts_s = -1600;
  s.bumpers = 0x05;
  s.gripper_state = static_cast<std::uint8_t>(GripperState::kClosed);
  s.gripper_percent = 100;
  s.flags =
      status_flag::kParametersReceived | status_flag::kMotorsActive | status_flag::kBeamBroken;
  s.rejected_frames = 2;
  return s;
}

TEST(SerialProtocolPage, ItsExamplesAreWhatTheFirmwareSpeaks) {
  const std::map<std::string, std::string> expected{
      {"0x01 Hello", hex(Hello{}, 1)},
      {"0x02 Parameters", hex(bench_parameters(500), 2)},
      {"0x03 Drive", hex(Drive{1600, -1600, 5200, 5200}, 259)},
      {"0x04 Stop", hex(Stop{}, 260)},
      {"0x05 Gripper", hex(Gripper{1}, 261)},
      {"0x06 StatusRequest", hex(StatusRequest{}, 262)},
      {"0x81 HelloReply",
       hex(HelloReply{kProtocolVersion, kFirmwareVersion, 7, 1234, name("io")}, 0)},
      {"0x82 Acknowledgement", hex(Acknowledgement{2, 2, 0}, 1)},
      {"0x83 Status", hex(status(), 2)}};
  EXPECT_EQ(examples(), expected);
}

TEST(SerialProtocolPage, TellsEveryPayloadsLength) {
  EXPECT_EQ(payload_size<Hello>(), 1u);
  EXPECT_EQ(payload_size<Parameters>(), 48u);
  EXPECT_EQ(payload_size<Drive>(), 12u);
  EXPECT_EQ(payload_size<Stop>(), 0u);
  EXPECT_EQ(payload_size<Gripper>(), 1u);
  EXPECT_EQ(payload_size<StatusRequest>(), 0u);
  EXPECT_EQ(payload_size<HelloReply>(), 26u);
  EXPECT_EQ(payload_size<Acknowledgement>(), 4u);
  EXPECT_EQ(payload_size<Status>(), 26u);
}

TEST(SerialProtocolPage, AMessageSurvivesPackingAndUnpacking) {
  std::array<std::uint8_t, kMaxEncoded> bytes;
  const auto size = encode_message(status(), 9, bytes);
  FrameDecoder decoder;
  bool complete = false;
  for (std::size_t i = 0; i < size; ++i) complete = decoder.push(bytes[i]);
  ASSERT_TRUE(complete);
  Status back;
  ASSERT_TRUE(unpack(decoder.frame(), back));
  EXPECT_EQ(hex(back, 9), hex(status(), 9));
  Drive other;
  EXPECT_FALSE(unpack(decoder.frame(), other));
}

}  // namespace
}  // namespace galilean::robot::firmware
