// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/touch_evidence.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

class TouchEvidenceTest : public testing::Test {
 protected:
  static constexpr Duration kPeriod = 100ms;  ///< between two reports

  void stand(int reports) {
    for (int i = 0; i < reports; ++i, now += kPeriod) touches.note_pose("io", at, now);
  }
  void drive(int reports) {
    for (int i = 0; i < reports; ++i, now += kPeriod) {
      at.position_m.x() += 0.03;
      touches.note_pose("io", at, now);
    }
  }
  /// Something is at a bumper 27 cm ahead.
  bool touches_ahead(const std::string& variable = "ahead") {
    return touches.is_new("io", variable, at.position_m + Vec2(0.27, 0), now);
  }

  TouchEvidence touches;
  Pose2 at;
  Time now{};
};

TEST_F(TouchEvidenceTest, ARobotThatDrivesTouchesSomethingThatStands) {
  drive(5);
  EXPECT_TRUE(touches_ahead());
}

TEST_F(TouchEvidenceTest, ARobotThatTurnsTouchesSomethingThatStands) {
  stand(10);
  at.heading_rad += 0.1;
  stand(1);
  EXPECT_TRUE(touches_ahead());
}

TEST_F(TouchEvidenceTest, SomethingComesToARobotThatStandsStill) {
  drive(5);
  stand(10);
  EXPECT_FALSE(touches_ahead());
}

TEST_F(TouchEvidenceTest, NothingIsKnownOfARobotThatWasNotSeenToMove) {
  EXPECT_FALSE(touches_ahead());
  stand(1);
  EXPECT_FALSE(touches_ahead("left"));
}

// The hand that begins a contest is still at the bumper when the robot starts.
TEST_F(TouchEvidenceTest, WhatCameToTheRobotSaysNothingUntilItIsGone) {
  stand(10);
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(touches_ahead());
    drive(2);
  }
  now += TouchEvidence::kReleased;
  drive(1);
  EXPECT_TRUE(touches_ahead());
}

TEST_F(TouchEvidenceTest, ATouchThatGoesOnCountsOnceUntilItsPlaceMoves) {
  drive(5);
  EXPECT_TRUE(touches_ahead());
  for (int i = 0; i < 20; ++i) {
    stand(1);
    EXPECT_FALSE(touches_ahead());
  }
  drive(2);
  EXPECT_TRUE(touches_ahead());
}

TEST_F(TouchEvidenceTest, EachVariableIsATouchOfItsOwn) {
  drive(5);
  EXPECT_TRUE(touches_ahead("left"));
  EXPECT_TRUE(touches_ahead("right"));
}

}  // namespace
}  // namespace galilean::monitor
