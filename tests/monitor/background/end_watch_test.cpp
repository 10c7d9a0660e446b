// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/background/end_watch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <future>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

// Each of them runs in a process of its own, since they end it.
class EndWatchDeathTest : public testing::Test {
 protected:
  EndWatchDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

void end_in_order() {
  std::promise<void> asked;
  EndWatch watch([&asked] { asked.set_value(); }, 1min);
  std::raise(SIGTERM);
  asked.get_future().wait();
  watch.forget();
  std::raise(SIGTERM);  // changes nothing more
  std::exit(3);
}

void hang() {
  std::promise<void> never;
  const EndWatch watch([] {}, 1ms);
  std::raise(SIGTERM);
  never.get_future().wait();
}

TEST_F(EndWatchDeathTest, ItAsksTheProcessToEnd) {
  EXPECT_EXIT(end_in_order(), testing::ExitedWithCode(3), "");
}

TEST_F(EndWatchDeathTest, ItEndsAProcessThatHangs) {
  EXPECT_EXIT(hang(), testing::ExitedWithCode(EXIT_FAILURE), "a part of it hangs");
}

}  // namespace
}  // namespace galilean::monitor
