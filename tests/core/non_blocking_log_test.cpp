// SPDX-License-Identifier: BSD-3-Clause
#include "core/non_blocking_log.h"

#include <gmock/gmock.h>
#include <poll.h>
#include <unistd.h>

#include <optional>
#include <ostream>
#include <string>
#include <thread>

namespace galilean {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class NonBlockingLogTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(pipe(ends), 0);
    log.emplace(ends[1], stream);
  }
  void TearDown() override {
    log.reset();
    close(ends[0]);
    close(ends[1]);
  }
  /// Everything that is in the pipe.
  std::string read_all() const {
    std::string all;
    char piece[4096];
    for (pollfd in{ends[0], POLLIN, 0}; poll(&in, 1, 0) == 1;) {
      const auto count = read(ends[0], piece, sizeof piece);
      if (count <= 0) break;
      all.append(piece, static_cast<std::size_t>(count));
    }
    return all;
  }

  int ends[2] = {-1, -1};
  std::ostream stream{nullptr};
  std::optional<NonBlockingLog> log;
};

TEST_F(NonBlockingLogTest, WritesWholeLines) {
  stream << "one " << 1;
  EXPECT_EQ(read_all(), "");
  stream << '\n' << "two\nthr" << std::flush;
  EXPECT_EQ(read_all(), "one 1\ntwo\n");
  stream << "ee" << std::endl;
  EXPECT_EQ(read_all(), "three\n");
}

TEST_F(NonBlockingLogTest, APipeThatNobodyReadsHoldsNobodyUpAndTheLossIsTold) {
  const std::string line(1000, 'x');
  for (int i = 0; i < 1000; ++i) stream << line << std::endl;
  EXPECT_TRUE(stream.good());
  EXPECT_THAT(read_all(), EndsWith("x\n"));
  stream << "again" << std::endl;
  const auto after = read_all();
  EXPECT_THAT(after, HasSubstr(" lines are missing here"));
  EXPECT_THAT(after, EndsWith("\nagain\n"));
}

TEST_F(NonBlockingLogTest, AVeryLongLineIsCut) {
  stream << std::string(100'000, 'y') << std::endl;
  EXPECT_EQ(read_all().size(), NonBlockingLog::kMostLineBytes);
}

TEST_F(NonBlockingLogTest, LinesOfThreadsStayWhole) {
  const auto write = [this](const char* word) {
    // Each thread has a stream of its own, because a stream's state is not for two threads.
    std::ostream mine(&*log);
    for (int i = 0; i < 100; ++i) mine << word << word << '\n';
  };
  std::thread other(write, "ab");
  write("cd");
  other.join();
  const auto all = read_all();
  EXPECT_EQ(all.size(), 1000U);
  EXPECT_EQ(all.find("abcd"), all.npos);
  EXPECT_EQ(all.find("cdab"), all.npos);
}

}  // namespace
}  // namespace galilean
