// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/limits/connections.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace galilean::monitor {
namespace {

using PlacePtr = std::shared_ptr<Connections::Place>;

ServerLimits few_connections() {
  ServerLimits limits;
  limits.connections = 4;
  limits.connections_of_address = 2;
  limits.connections_of_loopback = 4;
  limits.reserved_connections = 2;
  return limits;
}

class ConnectionsTest : public testing::Test {
 protected:
  PlacePtr admit(const std::string& address) { return all->admit(address, false); }
  /// Lets `place` wait under a name, by which `closed` tells that it was closed.
  void wait(const PlacePtr& place, const std::string& name) {
    place->wait([this, name] { closed.push_back(name); });
  }

  const std::shared_ptr<LimitCounts> counts = std::make_shared<LimitCounts>();
  const std::shared_ptr<Connections> all = std::make_shared<Connections>(few_connections(), counts);
  std::vector<std::string> closed;
};

TEST_F(ConnectionsTest, CountsWhatIsOpen) {
  auto first = admit("a");
  const auto second = admit("b");
  EXPECT_EQ(all->open(), 2U);
  first.reset();
  EXPECT_EQ(all->open(), 1U);
  EXPECT_FALSE(second->is_reserved());
}

TEST_F(ConnectionsTest, OfLongMessagesOnlySoMuchIsKept) {
  ServerLimits limits = few_connections();
  limits.messages_bytes = 1000;
  const auto bounded = std::make_shared<Connections>(limits, counts);
  const auto first = bounded->admit("a", false), second = bounded->admit("b", false);
  EXPECT_TRUE(first->keep(Connections::kFreeBytes + 900));
  EXPECT_TRUE(second->keep(Connections::kFreeBytes)) << "a short one always has room";
  EXPECT_TRUE(second->keep(100));
  EXPECT_FALSE(second->keep(1));
  EXPECT_EQ(counts->count(Limit::kMessages), 1U);
  first->let_go();
  EXPECT_TRUE(second->keep(1));
}

TEST_F(ConnectionsTest, WhatOneKeptIsFreeWhenItIsClosed) {
  ServerLimits limits = few_connections();
  limits.messages_bytes = 1000;
  const auto bounded = std::make_shared<Connections>(limits, counts);
  auto first = bounded->admit("a", false);
  const auto second = bounded->admit("b", false);
  EXPECT_TRUE(first->keep(Connections::kFreeBytes + 1000));
  EXPECT_FALSE(second->keep(Connections::kFreeBytes + 1));
  second->let_go();
  first.reset();
  EXPECT_TRUE(second->keep(Connections::kFreeBytes + 1));
}

TEST_F(ConnectionsTest, WorkIsDoneAtOnceOrInTurn) {
  const auto place = admit("a");
  int done = 0;
  place->in_turn([&] { ++done; });
  EXPECT_EQ(done, 1);
  std::vector<std::function<void()>> waiting;
  all->take_turns_by([&](std::function<void()> work) { waiting.push_back(std::move(work)); });
  place->in_turn([&] { ++done; });
  EXPECT_EQ(done, 1);
  ASSERT_EQ(waiting.size(), 1U);
  waiting.front()();
  EXPECT_EQ(done, 2);
}

TEST_F(ConnectionsTest, TheOneThatWaitedLongestMakesRoom) {
  std::vector<PlacePtr> places{admit("a"), admit("b"), admit("c"), admit("d")};
  wait(places[1], "b");
  wait(places[0], "a");
  wait(places[2], "c");
  places[1]->serve();
  wait(places[1], "b again");
  const auto next = admit("e");
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->is_reserved());
  EXPECT_EQ(closed, std::vector<std::string>{"a"});
  EXPECT_EQ(all->closed_for_others(), 1U);
  EXPECT_GE(counts->count(Limit::kConnections), 1U);
}

TEST_F(ConnectionsTest, OneAddressMakesRoomForItselfAlone) {
  const std::vector<PlacePtr> places{admit("a"), admit("a"), admit("b")};
  wait(places[2], "b");
  wait(places[1], "a");
  const auto next = admit("a");
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->is_reserved());
  EXPECT_EQ(closed, std::vector<std::string>{"a"});
  EXPECT_EQ(counts->count(Limit::kConnectionsOfAddress), 1U);
}

TEST_F(ConnectionsTest, WhereNobodyWaitsTheReserveIsLeft) {
  const std::vector<PlacePtr> places{admit("a"), admit("b"), admit("c"), admit("d")};
  const auto fifth = admit("e"), sixth = admit("f");
  ASSERT_TRUE(fifth && sixth);
  EXPECT_TRUE(fifth->is_reserved());
  EXPECT_TRUE(sixth->is_reserved());
  EXPECT_FALSE(admit("g")) << "two are reserved";
  wait(fifth, "fifth");
  const auto seventh = admit("g");
  ASSERT_TRUE(seventh) << "one of the reserve has asked for nothing";
  EXPECT_TRUE(seventh->is_reserved());
  EXPECT_EQ(closed, std::vector<std::string>{"fifth"});
}

TEST_F(ConnectionsTest, WhateverHappensTheCountsAreRightAtTheEnd) {
  std::mt19937 random(7);
  std::vector<PlacePtr> open;
  for (int step = 0; step < 20'000; ++step) {
    const auto choice = random() % 4;
    const std::string address(1, static_cast<char>('a' + random() % 5));
    if (choice == 0) {
      if (auto place = admit(address)) open.push_back(std::move(place));
    } else if (!open.empty()) {
      const auto which = random() % open.size();
      if (choice == 1) open.erase(open.begin() + static_cast<std::ptrdiff_t>(which));
      if (choice == 2) wait(open[which], "x");
      if (choice == 3) open[which]->serve();
    }
    ASSERT_EQ(all->open(), open.size());
  }
  open.clear();
  EXPECT_EQ(all->open(), 0U);
  EXPECT_FALSE(all->close_waiting());
}

TEST(LimitCounts, EachHasANameOfItsOwnAndIsToldOnce) {
  LimitCounts counts;
  std::vector<std::string> names;
  testing::internal::CaptureStderr();
  for (std::size_t each = 0; each < kLimitCount; ++each) {
    names.emplace_back(LimitCounts::name(static_cast<Limit>(each)));
    for (int i = 0; i < 3; ++i) counts.reached(static_cast<Limit>(each));
    EXPECT_EQ(counts.count(static_cast<Limit>(each)), 3U);
  }
  const auto told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(told, '\n'), static_cast<std::ptrdiff_t>(kLimitCount)) << told;
  for (const auto& name : names) EXPECT_EQ(std::ranges::count(names, name), 1) << name;
}

}  // namespace
}  // namespace galilean::monitor
