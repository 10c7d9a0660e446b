// SPDX-License-Identifier: BSD-3-Clause
#include "core/refusal_words.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

TEST(RefusalWords, NameTheTopicAndAgreeWithTheCount) {
  EXPECT_EQ(refusal_words("rt/io/state", 12, "RobotState.heading_rad is not a number"),
            "12 messages on /io/state were not taken: RobotState.heading_rad is not a number");
  EXPECT_EQ(refusal_words("(others)", 1, "too long"), "1 message was not taken: too long");
}

TEST(RefusalWords, WhatAStrangerNamedDrawsNothingInATerminal) {
  EXPECT_EQ(refusal_words("rt/\x1b[2J", 2, "no\nreason").find_first_of("\x1b\n"),
            std::string::npos);
}

}  // namespace
}  // namespace galilean
