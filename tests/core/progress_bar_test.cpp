// SPDX-License-Identifier: BSD-3-Clause
#include "core/progress_bar.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

class ProgressBarTest : public testing::Test {
 protected:
  SteppedClock clock;
  std::string written;
  ProgressBar::Setup setup{"reading run.mcap", clock,
                           [this](const std::string& text) { written += text; }};
};

TEST_F(ProgressBarTest, WhatTakesLessThanASecondShowsNone) {
  {
    ProgressBar bar(setup);
    bar.show(0.1);
    clock.advance(std::chrono::milliseconds(999));
    bar.show(0.9);
  }
  EXPECT_EQ(written, "");
}

TEST_F(ProgressBarTest, ShowsHowMuchIsDoneAndLeavesNothingBehind) {
  {
    ProgressBar bar(setup);
    clock.advance(std::chrono::seconds(1));
    bar.show(0.5);
    EXPECT_EQ(written, "\r\x1b[Kreading run.mcap [############            ] 50 %");
    bar.show(0.6);  // at once: not shown
    EXPECT_EQ(written.find("60"), std::string::npos);
    clock.advance(ProgressBar::kShowEach);
    bar.show(2);
  }
  EXPECT_TRUE(written.ends_with("] 100 %\r\x1b[K")) << written;
}

TEST_F(ProgressBarTest, ANameCannotSteerTheTerminal) {
  setup.task = "a\x1b[2J";
  ProgressBar bar(setup);
  clock.advance(std::chrono::seconds(1));
  bar.show(0);
  EXPECT_NE(written.find("aU+001B[2J ["), std::string::npos) << written;
}

}  // namespace
}  // namespace galilean
