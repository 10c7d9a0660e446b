// SPDX-License-Identifier: BSD-3-Clause
#include "core/termination.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

namespace galilean {
namespace {

/// As a program that polls for the first signal and ends in order, while a second one comes.
[[noreturn]] void end_in_order(int signal) {
  {
    const Termination termination;
    kill(getpid(), signal);
    pollfd event{termination.descriptor(), POLLIN, 0};
    poll(&event, 1, -1);
    kill(getpid(), SIGTERM);
  }
  _exit(0);
}

TEST(Termination, LetsTheProcessEndByItselfWhicheverSignalCame) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    EXPECT_EXIT(end_in_order(signal), testing::ExitedWithCode(0), "") << signal;
}

}  // namespace
}  // namespace galilean
