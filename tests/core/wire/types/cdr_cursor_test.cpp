// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/cdr_cursor.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/wire/types/member_header.h"

namespace galilean::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(CdrCursor, ReadsEitherByteOrderAndAlignsByTheVersion) {
  const Bytes little{0, 1, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
  CdrCursor first(little);
  EXPECT_EQ(first.read<std::uint8_t>(), 7);
  EXPECT_EQ(first.read<std::uint64_t>(), 1U);
  EXPECT_EQ(first.left(), 0U);
  const Bytes big{0, 6, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  CdrCursor second(big);
  EXPECT_EQ(second.read<std::uint8_t>(), 7);
  EXPECT_EQ(second.read<std::uint64_t>(), 1U);
  EXPECT_TRUE(first.ok() && second.ok() && second.is_second() && !first.is_second());
}

TEST(CdrCursor, ReadsNothingBehindTheEndOfAPart) {
  const Bytes message{0, 7, 0, 0, 2, 0, 0, 0, 5, 6, 9, 9};
  CdrCursor cursor(message);
  const auto whole = cursor.enter(cursor.read<std::uint32_t>());
  EXPECT_EQ(cursor.read<std::uint8_t>(), 5);
  EXPECT_EQ(cursor.left(), 1U);
  cursor.leave(whole);
  EXPECT_EQ(cursor.read<std::uint8_t>(), 9);
  EXPECT_TRUE(cursor.ok());
  EXPECT_EQ(cursor.read<std::uint32_t>(), 0U);
  EXPECT_FALSE(cursor.ok());
}

TEST(CdrCursor, APartCannotBeLargerThanWhatItIsIn) {
  const Bytes message{0, 7, 0, 0, 1, 2, 3, 4};
  CdrCursor cursor(message);
  (void)cursor.enter(5);
  EXPECT_FALSE(cursor.ok());
}

TEST(CdrCursor, AHeaderThatIsNoneIsRefused) {
  for (const Bytes& message : {Bytes{}, Bytes{0, 1, 0}, Bytes{1, 1, 0, 0}, Bytes{0, 4, 0, 0},
                               Bytes{0, 12, 0, 0}, Bytes{0, 255, 0, 0, 1, 2, 3, 4}})
    EXPECT_FALSE(CdrCursor(message).ok()) << message.size();
}

TEST(CdrCursor, ATextHasNoZeroAtItsEnd) {
  const Bytes message{0, 1, 0, 0, 3, 0, 0, 0, 'i', 'o', 0, 0, 0, 0, 0, 0};
  CdrCursor cursor(message);
  EXPECT_EQ(cursor.read_text(), "io");
  EXPECT_EQ(cursor.read_text(), "");
  EXPECT_TRUE(cursor.ok());
}

TEST(MemberHeader, TellsTheSizeByEachOfTheCodes) {
  const std::pair<std::uint8_t, std::size_t> expected[] = {
      {0x00, 1}, {0x10, 2}, {0x20, 4}, {0x30, 8}, {0x40, 5}, {0x50, 9}, {0x60, 24}, {0xF0, 44}};
  for (const auto& [code, size] : expected) {
    const Bytes message{0, 11, 0, 0, 17, 0, 0, code, 5, 0, 0, 0};
    CdrCursor cursor(message);
    const auto header = next_member(cursor);
    ASSERT_TRUE(header) << int{code};
    EXPECT_EQ(header->id, 17U);
    EXPECT_EQ(header->size, size) << int{code};
  }
}

TEST(MemberHeader, OfTheFirstVersionMayBeLongIgnoredOrTheLast) {
  const Bytes message{0,    3,    0, 0,                                // header
                      0x03, 0x3F, 4, 0, 1,    1,    1, 1,              // to be ignored
                      0x05, 0xC0, 2, 0,                                // with two flags
                      8,    8,    0, 0,                                // its value
                      0x01, 0x3F, 8, 0, 9,    0,    1, 0, 6, 0, 0, 0,  // a long one
                      0x02, 0x3F, 0, 0, 0x05, 0x00, 4, 0};             // the end
  CdrCursor cursor(message);
  const auto flagged = next_member(cursor);
  ASSERT_TRUE(flagged);
  EXPECT_EQ(flagged->id, 5U);
  EXPECT_EQ(flagged->size, 2U);
  cursor.leave(cursor.enter(flagged->size));
  const auto large = next_member(cursor);
  ASSERT_TRUE(large);
  EXPECT_EQ(large->id, 0x10009U);
  EXPECT_EQ(large->size, 6U);
  EXPECT_FALSE(next_member(cursor));
  EXPECT_TRUE(cursor.ok());
}

}  // namespace
}  // namespace galilean::wire
