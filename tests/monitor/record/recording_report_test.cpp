// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recording_report.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

TEST(RecordingReport, TellsEachLossUnderItsReasonAndNoReasonWithoutALoss) {
  EXPECT_EQ(losses_text({.lost = 5}), "5 lost before they reached the recorder");
  EXPECT_EQ(losses_text({.lost = 5, .overrun = 5}), "5 lost because the recorder was too slow");
  EXPECT_EQ(losses_text({.lost = 12, .overrun = 5}),
            "5 lost because the recorder was too slow, 7 lost before they reached the recorder");
  EXPECT_EQ(losses_text({.filled = 300, .lost = 2}),
            "2 lost before they reached the recorder, 300 recorded late, after a gap");
  EXPECT_EQ(losses_text({.lost = 0, .paused = 9}), "9 sent while it was paused");
  EXPECT_EQ(losses_text({.lost = std::nullopt, .sent_before = 3}),
            "an unknown number lost, 3 sent before it listened");
  EXPECT_EQ(losses_text({.lost = 0, .unwritten = 4, .left_out = 2}),
            "4 not written for want of room, 2 left out as was asked");
}

}  // namespace
}  // namespace galilean::monitor
