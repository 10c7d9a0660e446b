// SPDX-License-Identifier: BSD-3-Clause
// Orders on their way into a history whose disk does not answer.
#include "monitor/pushes/order_log.h"

#include <gmock/gmock.h>

#include <future>
#include <vector>

#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

class OrderLogTest : public testing::Test {
 protected:
  OrderLogTest() {
    worker.run([this] {
      is_held.set_value();
      may_go_on.get_future().wait();
    });
    is_held.get_future().wait();
  }
  ~OrderLogTest() override {
    if (!goes_on) go_on();
  }
  OrderLogTest(const OrderLogTest&) = delete;
  OrderLogTest& operator=(const OrderLogTest&) = delete;

  void go_on() {
    goes_on = true;
    may_go_on.set_value();
    worker.finish();
  }
  /// Takes in a hold, and keeps what is told of it in `told`.
  void order(const std::string& id) {
    msg::Command hold;
    hold.id = id;
    hold.author = "balch";
    hold.kind = msg::Command_Constants::HOLD;
    log.note(hold, [this](const Result<void>& kept) {
      told.push_back(kept ? "kept" : kept.error().message);
    });
  }

  const TemporaryFolder folder;
  SteppedClock clock;
  Team team{clock};
  boost::asio::io_context io{1};
  std::unique_ptr<History> history = History::open(folder / "history.sqlite").value();
  std::promise<void> is_held, may_go_on;
  bool goes_on = false;
  Worker worker{io};
  wire::Refusals refusals;
  OrderLog log{{io, worker, team, *history, clock, refusals}};
  std::vector<std::string> told;
};

TEST_F(OrderLogTest, WhoGaveOneIsAnsweredOnceThoughTheDiskDoesNotAnswer) {
  order("first");
  io.run_one();  // it looks after orders ten times a second
  EXPECT_THAT(told, SizeIs(0));
  clock.advance(OrderLog::kDiskPatience);
  while (told.empty()) io.run_one();
  EXPECT_THAT(told.front(), HasSubstr("the disk has not answered yet"));
  go_on();
  while (io.poll_one() > 0) {
  }
  EXPECT_THAT(told, SizeIs(1));
  const auto kept = history->orders(10);
  ASSERT_TRUE(kept);
  ASSERT_THAT(kept.value(), SizeIs(1)) << "it is kept all the same";
  EXPECT_EQ(kept.value()[0].author, "balch");
}

TEST_F(OrderLogTest, WhatIsKeptInTimeIsToldSo) {
  order("first");
  go_on();
  while (io.poll_one() > 0) {
  }
  EXPECT_EQ(told, std::vector<std::string>{"kept"});
}

}  // namespace
}  // namespace galilean::monitor
