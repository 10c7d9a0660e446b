// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/turns.h"

#include <gmock/gmock.h>

#include <boost/asio/post.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class TurnsTest : public testing::Test {
 protected:
  void take(const std::string& name) {
    turns->take([this, name] { done.push_back(name); });
  }

  boost::asio::io_context io{1};
  std::shared_ptr<Turns> turns = std::make_shared<Turns>(io);
  std::vector<std::string> done;
};

TEST_F(TurnsTest, EachHasItsTurnInOrderAndLater) {
  take("first");
  take("second");
  take("third");
  EXPECT_THAT(done, IsEmpty());
  io.run();
  EXPECT_THAT(done, ElementsAre("first", "second", "third"));
}

TEST_F(TurnsTest, OthersHaveTheThreadBetweenTwoOfThem) {
  std::size_t done_at_others_turn = 0;
  turns->take([&] {
    done.emplace_back("first");
    boost::asio::post(io, [&] { done_at_others_turn = done.size(); });
  });
  for (int i = 0; i < 100; ++i) take("another");
  io.run();
  EXPECT_EQ(done_at_others_turn, 1U);
  EXPECT_EQ(done.size(), 101U);
}

TEST_F(TurnsTest, WhatIsTakenInAWorkHasItsTurnBehindTheOthers) {
  turns->take([this] { take("asked by the first"); });
  take("second");
  io.run();
  EXPECT_THAT(done, ElementsAre("second", "asked by the first"));
}

TEST_F(TurnsTest, AfterTheEndNothingIsDone) {
  const auto owned = std::make_shared<int>(1);
  turns->take([this, owned] { done.emplace_back("first"); });
  turns->end();
  EXPECT_EQ(owned.use_count(), 1) << "what waited is dropped";
  take("late");
  io.run();
  EXPECT_THAT(done, IsEmpty());
}

}  // namespace
}  // namespace galilean::monitor
