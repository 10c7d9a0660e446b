// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/namesakes.h"

#include <gtest/gtest.h>

namespace galilean::front {
namespace {

const std::vector<std::string> kRobots{"io", "ganymede", "callisto"};

TEST(Namesakes, OthersMayLiveBesideADemo) {
  EXPECT_EQ(why_not_beside(kRobots, {}, 0), "");
  EXPECT_EQ(why_not_beside(kRobots, {.live = {"europa"}, .played = {"amalthea"}}, 0), "");
}

TEST(Namesakes, WhoLivesThereIsNamedWithTheDomainAndTheWayOut) {
  EXPECT_EQ(why_not_beside(kRobots, {.live = {"europa", "ganymede", "io"}, .played = {}}, 7),
            "io and ganymede live in DDS domain 7 already, and two robots of one name obey and "
            "tell as one; end those, or use another domain (--domain or ROS_DOMAIN_ID)");
  EXPECT_EQ(why_not_beside({"io"}, {.live = {"io"}, .played = {}}, 0),
            "io lives in DDS domain 0 already, and two robots of one name obey and tell as one; "
            "end that one, or use another domain (--domain or ROS_DOMAIN_ID)");
}

TEST(Namesakes, WhatAReplayPlaysIsInTheWay) {
  EXPECT_EQ(why_not_beside(kRobots, {.live = {}, .played = {"callisto"}}, 0),
            "a replay plays callisto in DDS domain 0 already; end it, or use another domain "
            "(--domain or ROS_DOMAIN_ID)");
}

}  // namespace
}  // namespace galilean::front
