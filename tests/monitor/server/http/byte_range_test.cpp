// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/byte_range.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using Kind = ByteRange::Kind;

void expect_part(const char* field, std::uint64_t offset, std::uint64_t bytes) {
  const auto range = byte_range(field, 1000);
  EXPECT_EQ(range.kind, Kind::kPart) << field;
  EXPECT_EQ(range.offset, offset) << field;
  EXPECT_EQ(range.bytes, bytes) << field;
}

TEST(ByteRange, IsThatPartOfTheFile) {
  expect_part("bytes=0-0", 0, 1);
  expect_part("bytes=0-99", 0, 100);
  expect_part("bytes=900-", 900, 100);
  expect_part("bytes=-1", 999, 1);
  expect_part("bytes=-5000", 0, 1000);
  expect_part("bytes=999-5000", 999, 1);
  expect_part("bytes=0-99999999999999999999999999", 0, 1000);
}

TEST(ByteRange, OutOfBoundsIsWhatTheFileHasNothingOf) {
  for (const char* field :
       {"bytes=1000-", "bytes=1000-2000", "bytes=-0", "bytes=99999999999999999999999999-"})
    EXPECT_EQ(byte_range(field, 1000).kind, Kind::kOutOfBounds) << field;
  EXPECT_EQ(byte_range("bytes=0-", 0).kind, Kind::kOutOfBounds);
}

TEST(ByteRange, WhatIsNoSingleRangeAsksForTheWhole) {
  for (const char* field : {"", "bytes=", "bytes=-", "bytes=5", "bytes=9-5", "bytes=a-b",
                            "bytes=0-1,5-6", "lines=0-9", "bytes= 0-9", "bytes=+1-2", "bytes=1--2"})
    EXPECT_EQ(byte_range(field, 1000).kind, Kind::kWhole) << field;
}

}  // namespace
}  // namespace galilean::monitor
