// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/disk_room.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

TEST(DiskRoom, IsThereUntilLessIsFreeThanMustBe) {
  std::uint64_t free = 1000;
  DiskRoom room(1000, [&] { return std::optional(free); });
  EXPECT_TRUE(room.look());
  free = 999;
  EXPECT_FALSE(room.look());
  EXPECT_EQ(room.free(), 999U);
}

TEST(DiskRoom, MustGrowByAQuarterBeforeItIsThereAgain) {
  std::uint64_t free = 999;
  DiskRoom room(1000, [&] { return std::optional(free); });
  EXPECT_FALSE(room.look());
  free = 1249;
  EXPECT_FALSE(room.look());
  free = 1250;
  EXPECT_TRUE(room.look());
  free = 1000;
  EXPECT_TRUE(room.look());
}

TEST(DiskRoom, IsAlwaysThereWhereNothingMustStayFree) {
  DiskRoom room(0, [] { return std::optional<std::uint64_t>(0); });
  EXPECT_TRUE(room.look());
}

TEST(DiskRoom, StaysAsItWasWhereTheSystemDoesNotSay) {
  std::optional<std::uint64_t> free;
  DiskRoom room(1000, [&] { return free; });
  EXPECT_TRUE(room.look());
  free = 1;
  EXPECT_FALSE(room.look());
  free.reset();
  EXPECT_FALSE(room.look());
}

TEST(FreeBytes, AreThoseOfTheDiskOfAFileThatIsNotThereYet) {
  const TemporaryFolder folder;
  const auto free = free_bytes(folder / "run.mcap");
  ASSERT_TRUE(free.has_value());
  EXPECT_EQ(*free > 0, std::filesystem::space(folder.path()).available > 0);
}

TEST(FreeBytes, AreUnknownOfADevice) {
  EXPECT_FALSE(free_bytes("/dev/null").has_value());
}

}  // namespace
}  // namespace galilean::monitor
