// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/losses.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/json_text.h"

namespace galilean::monitor {
namespace {

const WriterLosses kSome{.topic = "/io/state",
                         .process = "io",
                         .writer = "0a1b",
                         .recorded = 7,
                         .filled = 2,
                         .lost = 3,
                         .overrun = 1,
                         .sent_before = 4,
                         .unwritten = 2,
                         .left_out = 5,
                         .paused = 6};

TEST(Losses, AreReadAsTheyWereWritten) {
  EXPECT_EQ(read_losses(ordered_json_text(json_of(kSome))), kSome);
  WriterLosses keyed = kSome;
  keyed.lost = std::nullopt;
  EXPECT_EQ(read_losses(ordered_json_text(json_of(keyed))), keyed);
}

TEST(Losses, WhatIsSomethingElseIsNotRead) {
  for (const char* text : {"", "12", "[]", "{}", "{\"recorded\":", "\"recorded\""})
    EXPECT_FALSE(read_losses(text).has_value()) << text;
  EXPECT_EQ(read_losses(R"({"recorded": -1, "topic": 5})").value(), WriterLosses{});
}

TEST(Losses, WhatWasNotAskedForOrCameBeforeIsNotMissing) {
  EXPECT_EQ(kSome.missing(), 5U);
  EXPECT_EQ(total_missing({kSome, kSome}), 10U);
  EXPECT_EQ(total_missing({}), 0U);
}

TEST(Losses, BeyondThoseBeforeAreWhatCameSince) {
  WriterLosses later = kSome;
  later.recorded += 10;
  later.filled += 4;
  *later.lost += 2;
  later.unwritten += 1;
  const auto since = beyond(later, kSome);
  EXPECT_EQ(since.recorded, 10U);
  EXPECT_EQ(since.filled, 4U);
  EXPECT_EQ(since.missing(), 3U);
  EXPECT_EQ(since.sent_before, 0U);
  EXPECT_EQ(beyond(kSome, later).missing(), 0U);
}

}  // namespace
}  // namespace galilean::monitor
