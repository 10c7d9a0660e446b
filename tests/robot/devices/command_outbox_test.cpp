// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/command_outbox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace galilean::robot {
namespace {

using firmware::Drive;
using firmware::Gripper;
using firmware::Hello;
using firmware::Parameters;
using firmware::Stop;

/// A line that takes so many bytes, and decodes them.
struct SlowLine {
  std::size_t room = 0;
  firmware::FrameDecoder decoder;
  std::string types;  ///< the first letter of each frame
  std::vector<std::uint16_t> sequences;
  std::int16_t last_speed = 0;

  void flush(CommandOutbox& outbox, std::size_t bytes) {
    room = bytes;
    outbox.flush([this](auto offered) { return take(offered); });
  }
  std::size_t take(std::span<const std::uint8_t> offered) {
    const std::size_t taken = std::min(room, offered.size());
    for (std::size_t i = 0; i < taken; ++i)
      if (decoder.push(offered[i])) note(decoder.frame());
    room -= taken;
    return taken;
  }
  void note(const firmware::Frame& frame) {
    types += std::string("?HPDSG").at(frame.type);
    sequences.push_back(frame.sequence);
    Drive drive;
    if (frame.type == 3 && unpack(frame, drive)) last_speed = drive.left_speed_counts_s;
  }
};

constexpr std::size_t kMuch = 10000;

TEST(CommandOutbox, TheNewestDriveReplacesThoseThatWait) {
  CommandOutbox outbox;
  SlowLine line;
  for (std::int16_t speed = 1; speed <= 90; ++speed) {
    outbox.put(Drive{speed, speed, 0, 0});
    line.flush(outbox, 0);
  }
  line.flush(outbox, kMuch);
  EXPECT_EQ(line.types, "D");
  EXPECT_EQ(line.last_speed, 90);
  EXPECT_EQ(outbox.last_command(), 89);
}

TEST(CommandOutbox, AStopGoesFirstAndNoDriveAfterIt) {
  CommandOutbox outbox;
  SlowLine line;
  outbox.put(Parameters{});
  outbox.put(Drive{1, 1, 0, 0});
  outbox.put(Gripper{1});
  outbox.put(Stop{});
  line.flush(outbox, kMuch);
  EXPECT_EQ(line.types, "SPG");
  outbox.put(Stop{});
  outbox.put(Drive{2, 2, 0, 0});
  line.flush(outbox, kMuch);
  EXPECT_EQ(line.types, "SPGD") << "the stop is older than the drive";
}

TEST(CommandOutbox, AFrameThatIsPartlyWrittenIsFinishedFirst) {
  CommandOutbox outbox;
  SlowLine line;
  outbox.put(Drive{1, 1, 0, 0});
  line.flush(outbox, 7);
  outbox.put(Drive{2, 2, 0, 0});
  outbox.put(Stop{});
  line.flush(outbox, 5);
  outbox.drop_commands();
  outbox.put(Hello{});
  line.flush(outbox, kMuch);
  EXPECT_EQ(line.types, "DH");
  EXPECT_EQ(line.last_speed, 1);
  EXPECT_EQ(line.decoder.rejected(), 0u);
}

TEST(CommandOutbox, ALostLineLeavesNothing) {
  CommandOutbox outbox;
  SlowLine line;
  outbox.put(Drive{1, 1, 0, 0});
  line.flush(outbox, 7);
  outbox.put(Stop{});
  outbox.clear();
  EXPECT_EQ(outbox.last_command(), std::nullopt);
  line.flush(outbox, kMuch);
  EXPECT_EQ(line.types, "");
}

// Whatever is put, and however the line takes it: frames are whole, and a stop that was put last is
// the last motion that arrives.
TEST(CommandOutbox, WhateverTheLineTakesFramesAreWholeAndTheNewestMotionIsLast) {
  std::mt19937 random(11);
  const auto below = [&random](std::uint32_t n) { return random() % n; };
  for (int trial = 0; trial < 2000; ++trial) {
    CommandOutbox outbox;
    SlowLine line;
    char last = '?';
    for (int i = 0; i < 20; ++i) {
      switch (below(5)) {
        case 0:
          outbox.put(Drive{1, 1, 0, 0});
          last = 'D';
          break;
        case 1:
          outbox.put(Stop{});
          last = 'S';
          break;
        case 2:
          outbox.put(Gripper{1});
          break;
        case 3:
          outbox.put(Parameters{});
          break;
        default:
          line.flush(outbox, below(40));
      }
    }
    line.flush(outbox, kMuch);
    ASSERT_EQ(line.decoder.rejected(), 0u);
    const auto motion = line.types.find_last_of("DS");
    ASSERT_EQ(motion == std::string::npos ? '?' : line.types[motion], last) << trial;
  }
}

}  // namespace
}  // namespace galilean::robot
