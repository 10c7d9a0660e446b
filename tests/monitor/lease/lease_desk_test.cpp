// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/lease/lease_desk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

const OperatorId kAda{.name = "ada", .account = "operator", .client = "tab-1"};
const OperatorId kAdasTerminal{.name = "ada", .account = "operator", .client = "4711"};
const OperatorId kBen{.name = "ben", .account = "operator", .client = "tab-2"};
const OperatorId kCarol{.name = "carol", .account = "carols", .client = "tab-3"};

class LeaseDeskTest : public testing::Test {
 protected:
  [[nodiscard]] Result<void> act(LeaseDeed deed, const OperatorId& who,
                                 const std::string& reason = {}) {
    return desk_.act(deed, who, {"io"}, reason);
  }
  [[nodiscard]] Result<void> steer(const OperatorId& who, const LeaseDesk::Robots& robots) {
    return desk_.admit(OrderKind::kSteers, who, robots);
  }
  [[nodiscard]] std::string holder(const std::string& robot = "io") const {
    const Lease* lease = desk_.find(robot);
    return lease && lease->state() != LeaseState::kFree ? lease->holder().name : "";
  }
  /// Returns in words what changed since the last call.
  std::vector<std::string> told() {
    desk_.refresh();
    std::vector<std::string> words;
    for (const auto& change : desk_.take_changes())
      words.push_back(change.robot + ": " + in_words(change));
    return words;
  }
  /// Lets time pass, while all of `talking` say something each second.
  void pass(int count_s, const std::vector<OperatorId>& talking) {
    for (int i = 0; i < count_s; ++i) {
      clock_.advance(seconds(1));
      for (const auto& who : talking) desk_.hear(who);
    }
    desk_.refresh();
  }

  SteppedClock clock_;
  LeaseDesk desk_{clock_};
};

TEST_F(LeaseDeskTest, WhoSteersFirstGetsAFreeLeaseAndOthersAreToldWhoHoldsIt) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  EXPECT_EQ(holder(), "ada");
  const auto refused = steer(kBen, {"io"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "Nothing was done: ada holds io. Ask for it, or take it over with a reason.");
  EXPECT_THAT(told(), ElementsAre("io: ada holds it now"));
}

TEST_F(LeaseDeskTest, OnePersonSteersFromAllTabsAndProcessesAndNothingIsTold) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(steer(kAdasTerminal, {"io"}));
  EXPECT_THAT(told(), ElementsAre("io: ada holds it now"));
  ASSERT_TRUE(act(LeaseDeed::kRelease, kAdasTerminal));
  EXPECT_EQ(holder(), "ada") << "her page may go on with it";
  pass(9, {kAda});
  EXPECT_EQ(holder(), "ada");
  pass(10, {});
  EXPECT_EQ(holder(), "");
  ASSERT_TRUE(steer(kAdasTerminal, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kRelease, kAda)) << "that is nothing: her page does not hold it";
  EXPECT_EQ(holder(), "ada");
  ASSERT_TRUE(act(LeaseDeed::kRelease, kAdasTerminal));
  EXPECT_EQ(holder(), "");
}

TEST_F(LeaseDeskTest, TheSameNameWithAnotherTokenIsAnotherPerson) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  EXPECT_FALSE(steer({.name = "ada", .account = "adas", .client = "tab-1"}, {"io"}));
}

TEST_F(LeaseDeskTest, AnOrderToTheTeamIsRefusedAsAWholeAndNamesWhoHoldsWhich) {
  ASSERT_TRUE(steer(kAda, {"io", "ganymede"}));
  ASSERT_TRUE(steer(kBen, {"callisto"}));
  const auto refused = steer(kCarol, {"callisto", "europa", "ganymede", "io"});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message,
              HasSubstr("ada holds ganymede and io, ben holds callisto. Ask for them"));
  EXPECT_EQ(holder("europa"), "") << "a part of the order would have been done";
  EXPECT_TRUE(steer(kCarol, {"europa"}));
}

TEST_F(LeaseDeskTest, AnybodysStopNeedsNoLeaseAndTakesNone) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  EXPECT_TRUE(desk_.admit(OrderKind::kStops, kBen, {"io", "callisto"}));
  EXPECT_EQ(holder(), "ada");
  EXPECT_EQ(holder("callisto"), "");
}

TEST_F(LeaseDeskTest, TheHolderGivesOrRefuses) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  EXPECT_FALSE(act(LeaseDeed::kGive, kBen)) << "who asks does not answer";
  EXPECT_FALSE(act(LeaseDeed::kAsk, kCarol)) << "one asks at a time";
  ASSERT_TRUE(act(LeaseDeed::kRefuse, kAda, "I am parking"));
  EXPECT_EQ(holder(), "ada");
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  ASSERT_TRUE(act(LeaseDeed::kGive, kAda));
  EXPECT_EQ(holder(), "ben");
  EXPECT_FALSE(act(LeaseDeed::kGive, kBen)) << "nobody asks";
  EXPECT_THAT(told(), ElementsAre("io: ada holds it now", "io: ben asks ada for it",
                                  "io: ada did not give it to ben: I am parking",
                                  "io: ben asks ada for it", "io: ada gave it to ben"));
}

TEST_F(LeaseDeskTest, WhoAsksGetsItAfterTenSecondsWithoutAnswer) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  pass(5, {kAda, kBen});
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen)) << "to ask again does not begin the time again";
  pass(4, {kAda, kBen});
  EXPECT_EQ(holder(), "ada");
  pass(1, {kAda, kBen});
  EXPECT_EQ(holder(), "ben");
  EXPECT_EQ(told().back(), "io: ben holds it now, because ada did not answer");
  EXPECT_FALSE(steer(kAda, {"io"}));
}

TEST_F(LeaseDeskTest, ItIsTakenOverAtOnceWithAReasonOnly) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kAsk, kCarol));
  const auto without = act(LeaseDeed::kTake, kBen);
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().message, HasSubstr("reason"));
  ASSERT_TRUE(act(LeaseDeed::kTake, kBen, "it stands in the door"));
  EXPECT_EQ(holder(), "ben");
  EXPECT_EQ(desk_.find("io")->state(), LeaseState::kHeld) << "carol asked ada, and not ben";
  EXPECT_EQ(told().back(), "io: ben took it over from ada: it stands in the door");
}

TEST_F(LeaseDeskTest, ALeaseEndsWithItsHoldersSilence) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  pass(30, {kAda});
  EXPECT_EQ(holder(), "ada");
  pass(9, {});
  EXPECT_EQ(holder(), "ada");
  pass(1, {});
  EXPECT_EQ(holder(), "");
  EXPECT_EQ(told().back(), "io: ada says nothing any more; nobody holds it now");
  EXPECT_TRUE(steer(kBen, {"io"}));
}

TEST_F(LeaseDeskTest, WhoAskedGetsWhatAHolderLeavesOrLosesBySilence) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  pass(5, {});
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  pass(5, {kBen});
  EXPECT_EQ(told().back(), "io: ada says nothing any more; ben holds it now");
  ASSERT_TRUE(act(LeaseDeed::kAsk, kCarol));
  ASSERT_TRUE(act(LeaseDeed::kRelease, kBen));
  EXPECT_EQ(told().back(), "io: ben let it go; carol holds it now");
}

TEST_F(LeaseDeskTest, WhoAsksMayWithdraw) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  ASSERT_TRUE(act(LeaseDeed::kRelease, kBen));
  pass(20, {kAda, kBen});
  EXPECT_EQ(holder(), "ada");
  EXPECT_EQ(told().back(), "io: ben does not ask ada for it any more");
}

TEST_F(LeaseDeskTest, WhatIsDueComesInItsOrderHoweverLateItIsLookedAt) {
  ASSERT_TRUE(steer(kAda, {"io"}));
  ASSERT_TRUE(act(LeaseDeed::kAsk, kBen));
  clock_.advance(std::chrono::hours(1));
  EXPECT_THAT(told(), ElementsAre("io: ada holds it now", "io: ben asks ada for it",
                                  "io: ben holds it now, because ada did not answer",
                                  "io: ben says nothing any more; nobody holds it now"));
}

TEST_F(LeaseDeskTest, ARobotThatTheMonitorForgetsIsHeldByNobodyWhenItComesBack) {
  ASSERT_TRUE(steer(kAda, {"io", "callisto"}));
  desk_.forget("io");
  desk_.forget("europa");
  EXPECT_EQ(desk_.find("io"), nullptr);
  EXPECT_THAT(desk_.robots_of(kAda), ElementsAre("callisto"));
  ASSERT_TRUE(steer(kBen, {"io"}));
  EXPECT_EQ(holder(), "ben");
}

}  // namespace
}  // namespace galilean::monitor
