// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/inputs_tap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/inputs/bit_digest.h"
#include "robot/inputs/picture_packing.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

constexpr const char* kStill = "states: state: name: \"still\" end end\n";

std::vector<TickRecord> taken(InputsTap& tap) {
  std::vector<TickRecord> all;
  for (TickRecord record; tap.take(record);) all.push_back(record);
  return all;
}

TEST(InputsTap, HandsOverEveryTickAndEveryPictureOnce) {
  InputsTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load(kStill));
  robot.tick(2);
  robot.camera.picture.number = 5;
  robot.camera.picture.rgb[7] = 77;
  robot.tick();
  TickRecord record;
  ASSERT_TRUE(tap.take(record));
  EXPECT_EQ(record.tick, 1U);
  EXPECT_EQ(record.taken_over, 1U);
  EXPECT_FALSE(record.has_picture);
  ASSERT_TRUE(tap.take(record));
  EXPECT_EQ(record.taken_over, 0U);
  ASSERT_TRUE(tap.take(record));
  ASSERT_TRUE(record.has_picture);
  EXPECT_EQ(tap.picture().number, 5U);
  EXPECT_EQ(tap.picture().rgb[7], 77);
  robot.tick();
  ASSERT_TRUE(tap.take(record));
  EXPECT_FALSE(record.has_picture) << "it is the same one";
  EXPECT_FALSE(tap.take(record));
}

TEST(InputsTap, CountsTicksForWhichThereIsNoRoom) {
  InputsTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load(kStill));
  robot.tick(InputsTap::kMostTicks + 3);
  EXPECT_EQ(tap.lost(), 3U);
  EXPECT_EQ(taken(tap).size(), InputsTap::kMostTicks);
  robot.tick();
  EXPECT_EQ(taken(tap).front().tick, InputsTap::kMostTicks + 4);
}

TEST(InputsTap, APictureWhoseTickIsLostComesWithTheNextOne) {
  InputsTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load(kStill));
  robot.tick(InputsTap::kMostTicks);
  robot.camera.picture.number = 9;
  robot.tick();
  ASSERT_EQ(taken(tap).size(), InputsTap::kMostTicks);
  robot.tick();
  TickRecord record;
  ASSERT_TRUE(tap.take(record));
  ASSERT_TRUE(record.has_picture);
  EXPECT_EQ(tap.picture().number, 9U);
}

TEST(InputsTap, HandsNothingOverWhileNobodyWantsIt) {
  InputsTap tap;
  TestRobot robot(1, {&tap});
  ASSERT_TRUE(robot.load(kStill));
  robot.camera.picture.number = 1;
  robot.tick();
  ASSERT_EQ(taken(tap).size(), 1U);
  tap.want(false);
  robot.tick(200);
  EXPECT_TRUE(taken(tap).empty());
  EXPECT_EQ(tap.lost(), 0U);
  tap.want(true);
  robot.tick();
  const auto again = taken(tap);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_TRUE(again[0].has_picture) << "who wants it now has seen none";
}

TEST(PicturePacking, LosesNothing) {
  Frame frame;
  paint_office(frame);
  for (std::size_t i = 0; i < frame.rgb.size(); i += 7)
    frame.rgb[i] = static_cast<std::uint8_t>(i * i >> 3);
  PicturePacker packer;
  std::vector<std::uint8_t> packed, unpacked(frame.rgb.size());
  packer.pack(frame.rgb, packed);
  EXPECT_LT(packed.size(), frame.rgb.size());
  ASSERT_TRUE(unpack(packed, unpacked));
  EXPECT_TRUE(std::ranges::equal(unpacked, frame.rgb));
  packed.resize(packed.size() / 2);
  EXPECT_FALSE(unpack(packed, unpacked));
}

TEST(BitDigest, DiffersWithEveryBit) {
  const auto digest = [](double number) {
    BitDigest made;
    made.add(number);
    return made.value();
  };
  EXPECT_NE(digest(0.0), digest(-0.0));
  EXPECT_NE(digest(1), digest(std::nextafter(1, 2)));
  std::vector<std::uint8_t> pixels(1000);
  const auto of_pixels = [&] {
    BitDigest made;
    made.add(std::span<const std::uint8_t>(pixels));
    return made.value();
  };
  const auto before = of_pixels();
  for (auto& pixel : pixels) {
    pixel ^= 1;
    EXPECT_NE(of_pixels(), before);
    pixel ^= 1;
  }
}

}  // namespace
}  // namespace galilean::robot
