// SPDX-License-Identifier: BSD-3-Clause
#include "core/last_sentence.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>

namespace galilean {
namespace {

// Each of them runs in a process of its own. An exception is thrown on a thread, where nobody
// catches it.
class LastSentenceDeathTest : public testing::Test {
 protected:
  LastSentenceDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
  template <class Fault>
  static void end_by(Fault fault) {
    say_why_it_ends("galilean-test");
    std::thread([fault]() noexcept { fault(); }).join();
  }
};

TEST_F(LastSentenceDeathTest, WithoutMemoryItSaysSoAndEndsWithOne) {
  EXPECT_EXIT(end_by([] { throw std::bad_alloc(); }), testing::ExitedWithCode(EXIT_FAILURE),
              "galilean-test: it ends at once, because no memory is left");
}

TEST_F(LastSentenceDeathTest, AnExceptionThatNobodyCatchesIsTold) {
  EXPECT_EXIT(end_by([] { throw std::runtime_error("the bridge is gone"); }),
              testing::KilledBySignal(SIGABRT),
              "galilean-test: it ends at once, because the bridge is gone");
}

TEST_F(LastSentenceDeathTest, SoIsAnAbort) {
  EXPECT_EXIT(end_by([] { std::abort(); }), testing::KilledBySignal(SIGABRT),
              "because a library aborted it");
}

}  // namespace
}  // namespace galilean
