// SPDX-License-Identifier: BSD-3-Clause
#include "core/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace galilean {
namespace {

enum class Colour : std::uint8_t { kRed, kBlue };

struct Mind {
  double number = 0;
  std::int32_t negative = 0;
  bool sure = false;
  Colour colour = Colour::kRed;
  Time time{};
  Vec2 place = Vec2::Zero();
  std::optional<Time> drawn;
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(13);
  StaticVector<int, 4> list;

  void keep(Memory& memory) {
    memory.keep(number);
    memory.keep(negative);
    memory.keep(sure);
    memory.keep(colour);
    memory.keep(time);
    memory.keep(place);
    memory.keep(drawn);
    memory.keep(std::span<std::uint8_t>(pixels));
    memory.keep(list, [](Memory& to, int& each) { to.keep(each); });
  }
};

Mind full() {
  Mind mind{.number = -0.0, .negative = -7, .sure = true, .colour = Colour::kBlue};
  mind.time = Time{Duration{-3}};
  mind.place = {std::numeric_limits<double>::denorm_min(), 2};
  mind.drawn = Time{Duration{5}};
  for (std::size_t i = 0; i < mind.pixels.size(); ++i)
    mind.pixels[i] = static_cast<std::uint8_t>(i + 200);
  mind.list.push_back(4);
  mind.list.push_back(-5);
  return mind;
}

std::vector<std::uint64_t> saved(Mind mind) {
  std::vector<std::uint64_t> room(100);
  Memory memory = Memory::saving(room);
  mind.keep(memory);
  EXPECT_TRUE(memory.fits());
  room.resize(memory.words());
  return room;
}

TEST(Memory, GivesBackEveryBit) {
  const auto words = saved(full());
  Mind other;
  other.drawn = Time{};
  other.list.push_back(1);
  Memory memory = Memory::loading(words);
  other.keep(memory);
  EXPECT_TRUE(memory.fits());
  EXPECT_EQ(memory.words(), words.size());
  EXPECT_TRUE(std::signbit(other.number));
  EXPECT_EQ(other.negative, -7);
  EXPECT_TRUE(other.sure);
  EXPECT_EQ(other.colour, Colour::kBlue);
  EXPECT_EQ(other.time, Time{Duration{-3}});
  EXPECT_EQ(other.drawn, Time{Duration{5}});
  EXPECT_EQ(other.pixels, full().pixels);
  EXPECT_EQ(other.place.x(), std::numeric_limits<double>::denorm_min());
  ASSERT_EQ(other.list.size(), 2U);
  EXPECT_EQ(other.list[1], -5);
  EXPECT_EQ(saved(other), words);
}

TEST(Memory, SavesNothingWhereThereIsNoRoom) {
  std::vector<std::uint64_t> room(3, 99);
  Memory memory = Memory::saving(std::span(room).first(2));
  full().keep(memory);
  EXPECT_FALSE(memory.fits());
  EXPECT_EQ(room[2], 99U);
}

TEST(Memory, ReadsNothingBehindTheEnd) {
  auto words = saved(full());
  words.resize(words.size() - 1);
  Mind other;
  Memory memory = Memory::loading(words);
  other.keep(memory);
  EXPECT_FALSE(memory.fits());
}

TEST(Memory, AListThatIsLongerThanItsRoomIsCut) {
  Mind mind = full();
  auto words = saved(mind);
  words[words.size() - 3] = 1'000'000;
  Mind other;
  Memory memory = Memory::loading(words);
  other.keep(memory);
  EXPECT_EQ(other.list.size(), 4U);
  EXPECT_FALSE(memory.fits());
}

}  // namespace
}  // namespace galilean
