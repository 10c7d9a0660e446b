// SPDX-License-Identifier: BSD-3-Clause
// What operators are told of a map that fails, stands still or is given too much.
#include "monitor/map/map_watch.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

class MapWatchTest : public testing::Test {
 protected:
  SteppedClock clock;
  MapWatch watch{clock};
};

TEST_F(MapWatchTest, AMapThatGoesOnHasNoProblem) {
  EXPECT_EQ(watch.problem(), "");
  clock.advance(MapWatch::kPatience);
  EXPECT_EQ(watch.problem(), "") << "an update may take so long";
  watch.note_alive();
  clock.advance(MapWatch::kPatience);
  EXPECT_EQ(watch.problem(), "");
}

TEST_F(MapWatchTest, AMapThatStandsStillSaysForHowLongUntilItGoesOn) {
  clock.advance(4500ms);
  EXPECT_THAT(watch.problem(), StartsWith("The map has stood still for 4 s. Stop, hold and"));
  watch.note_alive();
  EXPECT_EQ(watch.problem(), "");
}

TEST_F(MapWatchTest, AFailureIsToldForAWhileAndCounted) {
  watch.note_failure("out of chalk");
  EXPECT_THAT(watch.problem(), StartsWith("The map loses updates: out of chalk. Stop, hold and"));
  clock.advance(MapWatch::kTold / 2);
  watch.note_alive();
  watch.note_failure("out of ink");
  clock.advance(MapWatch::kTold / 2);
  watch.note_alive();
  EXPECT_THAT(watch.problem(), HasSubstr("out of ink")) << "it goes on";
  clock.advance(MapWatch::kTold / 2);
  watch.note_alive();
  EXPECT_EQ(watch.problem(), "");
  EXPECT_EQ(watch.failures(), 2U);
}

TEST_F(MapWatchTest, WhatIsDroppedIsToldWithItsCount) {
  watch.note_dropped();
  watch.note_dropped();
  EXPECT_THAT(watch.problem(), HasSubstr("dropped 2 of them"));
  EXPECT_EQ(watch.dropped(), 2U);
  clock.advance(MapWatch::kTold);
  watch.note_alive();
  EXPECT_EQ(watch.problem(), "");
}

}  // namespace
}  // namespace galilean::monitor
