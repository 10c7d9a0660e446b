// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/number_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <thread>
#include <vector>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

class NumberFileTest : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::filesystem::path file = number_file(folder / "operator.key");
};

TEST_F(NumberFileTest, NumbersRiseOverProcessesAndRestarts) {
  EXPECT_EQ(file.filename(), "operator.key.number");
  NumberFile monitor(file);
  EXPECT_EQ(monitor.take(1000), 1000U);
  NumberFile command(file);
  EXPECT_EQ(command.take(900), 1001U) << "its clock was set back";
  EXPECT_EQ(monitor.take(2000), 2000U);
  NumberFile after(file);
  EXPECT_EQ(after.take(1), 2001U);
  struct stat status {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(NumberFileTest, ADamagedFileIsAsNone) {
  for (const std::string text : {"", "12", "nonsense of twenty..", "99999999999999999999",
                                 "18446744073709551615", "-0000000000000000001"}) {
    std::ofstream(file) << text;
    EXPECT_EQ(NumberFile(file).take(5), 5U) << text;
    std::filesystem::remove(file);
  }
}

TEST_F(NumberFileTest, WhereNoFileCanBeTheClockCounts) {
  EXPECT_EQ(NumberFile().take(7), 7U);
  EXPECT_EQ(NumberFile(folder.path()).take(7), 7U) << "it is a folder";
  EXPECT_EQ(NumberFile(folder / "none" / "operator.key.number").take(7), 7U);
}

TEST_F(NumberFileTest, AProcessThatHangsDelaysNobody) {
  NumberFile numbers(file);
  EXPECT_EQ(numbers.take(10), 10U);
  const int other = open(file.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(other, 0);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  EXPECT_EQ(numbers.take(5), 5U);
  close(other);
  EXPECT_EQ(numbers.take(5), 11U);
}

TEST_F(NumberFileTest, ThreadsOfOneProcessGetEachNumberOnce) {
  constexpr int kThreads = 4, kEach = 200;
  NumberFile numbers(file);
  std::vector<std::vector<std::uint64_t>> taken(kThreads);
  {
    std::vector<std::jthread> threads;
    for (auto& mine : taken)
      threads.emplace_back([&numbers, &mine] {
        for (int i = 0; i < kEach; ++i) mine.push_back(numbers.take(1));
      });
  }
  std::set<std::uint64_t> all;
  for (const auto& mine : taken) all.insert(mine.begin(), mine.end());
  EXPECT_EQ(all.size(), std::size_t{kThreads * kEach});
}

}  // namespace
}  // namespace galilean
