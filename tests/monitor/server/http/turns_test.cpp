// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/turns.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class TurnsTest : public testing::Test {
 protected:
  /// Takes work that lasts so long and then tells its name.
  void take(const std::string& name, Duration lasting = 0ms) {
    turns->take([this, name, lasting] {
      clock.advance(lasting);
      done.push_back(name);
    });
  }
  /// Lets so much time pass, and does what is due then.
  void pass(Duration time) {
    clock.advance(time);
    io.restart();
    io.run_one();
  }

  SteppedClock clock;
  boost::asio::io_context io{1};
  std::shared_ptr<Turns> turns = std::make_shared<Turns>(io, clock);
  std::vector<std::string> done;
};

TEST_F(TurnsTest, ShortWorkIsDoneAtOnce) {
  clock.advance(1s);
  for (int i = 0; i < 5; ++i) take("short", 100us);
  EXPECT_EQ(done.size(), 5U);
}

TEST_F(TurnsTest, AfterLongWorkTheOthersWaitForAsLong) {
  clock.advance(1s);
  take("long", 10ms);
  take("second", 10ms);
  take("third");
  EXPECT_THAT(done, ElementsAre("long")) << "it had a burst's time, and waits for the rest";
  pass(9ms);
  EXPECT_THAT(done, ElementsAre("long", "second"));
  pass(10ms);
  EXPECT_THAT(done, ElementsAre("long", "second", "third"));
}

TEST_F(TurnsTest, VeryMuchShortWorkWaitsToo) {
  clock.advance(1s);
  for (int i = 0; i < 100; ++i) take("short", 100us);
  EXPECT_LT(done.size(), 20U);
  EXPECT_GE(done.size(), 5U);
  for (int i = 0; i < 200 && done.size() < 100; ++i) pass(1ms);
  EXPECT_EQ(done.size(), 100U);
}

TEST_F(TurnsTest, WhatAsksForMoreIsBehindTheOthers) {
  clock.advance(1s);
  take("long", 10ms);
  turns->take([this] {
    clock.advance(10ms);
    take("asked for");
  });
  take("other");
  pass(10ms);
  pass(20ms);
  EXPECT_THAT(done, ElementsAre("long", "other", "asked for"));
}

TEST_F(TurnsTest, AfterTheEndNothingIsDone) {
  clock.advance(1s);
  take("long", 10ms);
  const auto owned = std::make_shared<int>(1);
  turns->take([this, owned] { done.emplace_back("waits"); });
  turns->end();
  EXPECT_EQ(owned.use_count(), 1) << "what waited is dropped";
  take("late");
  pass(1s);
  EXPECT_THAT(done, ElementsAre("long"));
}

}  // namespace
}  // namespace galilean::monitor
