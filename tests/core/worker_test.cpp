// SPDX-License-Identifier: BSD-3-Clause
#include "core/worker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <vector>

#include "core/failure.h"

namespace galilean {
namespace {

using testing::ElementsAre;

constexpr Duration kShort = std::chrono::microseconds(100);

TEST(Worker, DoesItsRoundsUntilItIsEnded) {
  std::atomic<int> rounds{0};
  std::promise<void> often;
  {
    const Worker worker(
        [&](const std::stop_token& stop) {
          if (++rounds == 10) often.set_value();
          sleep_for(kShort, stop);
        },
        [](const std::string&) {});
    often.get_future().wait();
  }
  const int at_the_end = rounds;
  std::this_thread::yield();
  EXPECT_EQ(rounds, at_the_end);
}

TEST(Worker, ReportsOnceWhatItsRoundsThrowAndTriesAgainUntilTheySucceed) {
  std::vector<std::string> reports;
  std::promise<void> well;
  int rounds = 0;
  {
    const Worker worker(
        [&](const std::stop_token& stop) {
          if (++rounds <= 2) throw std::runtime_error("no paper");
          if (rounds == 5) well.set_value();
          sleep_for(kShort, stop);
        },
        [&](const std::string& failure) { reports.push_back(failure); });
    well.get_future().wait();
  }
  EXPECT_THAT(reports, ElementsAre("no paper", ""));
}

TEST(Worker, ReportsAgainWhatAReportCouldNotTell) {
  std::promise<std::string> told;
  int attempts = 0;
  const Worker worker([](const std::stop_token&) { throw std::runtime_error("no paper"); },
                      [&](const std::string& failure) {
                        if (++attempts == 1) throw std::bad_alloc();
                        told.set_value(failure);
                      });
  EXPECT_EQ(told.get_future().get(), "no paper");
}

TEST(Worker, EndsWhereItsRoundsFail) {
  std::promise<void> failed;
  const Worker worker([](const std::stop_token&) { throw 7; },
                      [&](const std::string&) { failed.set_value(); });
  failed.get_future().wait();
}

TEST(FailureOf, IsWhatWasThrownInWords) {
  EXPECT_TRUE(attempt([] {}));
  EXPECT_EQ(attempt([] { throw std::runtime_error("no paper"); }).error().message, "no paper");
  EXPECT_NE(attempt([] { throw std::runtime_error(""); }).error().message, "");
  EXPECT_NE(attempt([] { throw 7; }).error().message, "");
}

}  // namespace
}  // namespace galilean
