// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/order_keeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

class OrderKeeperTest : public testing::Test {
 protected:
  [[nodiscard]] OrderNumbers read() const {
    const auto kept = read_order_numbers(file);
    return kept ? kept.value() : OrderNumbers{{"it cannot be read", 0}};
  }
  [[nodiscard]] std::string text() const {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& content) const { std::ofstream(file) << content; }

  const TemporaryFolder folder;
  const std::filesystem::path file = order_numbers_file(folder.path(), "io", 3);
  const OrderNumbers numbers{{"0123456789abcdef", 1'800'000'000'000'000'000},
                             {"fedcba9876543210", 18'446'744'073'709'551'615U}};
};

TEST_F(OrderKeeperTest, ANewRobotRemembersNothing) {
  EXPECT_EQ(file, folder / "robots" / "domain_3" / "io.orders");
  EXPECT_EQ(read(), OrderNumbers());
}

TEST_F(OrderKeeperTest, WhatIsWrittenIsReadAgain) {
  ASSERT_TRUE(write_order_numbers(file, numbers));
  EXPECT_EQ(read(), numbers);
  struct stat status {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  ASSERT_TRUE(write_order_numbers(file, {}));
  EXPECT_EQ(read(), OrderNumbers());
}

TEST_F(OrderKeeperTest, AFileThatIsCutShortAnywhereIsNotBelieved) {
  ASSERT_TRUE(write_order_numbers(file, numbers));
  const std::string whole = text();
  for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
    write(whole.substr(0, size));
    EXPECT_FALSE(read_order_numbers(file)) << size << " characters";
  }
}

TEST_F(OrderKeeperTest, SaysWhichFileIsNotWhatARobotWrote) {
  ASSERT_TRUE(write_order_numbers(file, {}));
  for (const std::string line : {"0123456789abcdef", "0123456789abcdef x", " 5", "a -1",
                                 "a 18446744073709551616", "a 5 6"}) {
    write("galilean orders, version 1\n" + line + "\nend\n");
    const auto wrong = read_order_numbers(file);
    ASSERT_FALSE(wrong) << line;
    EXPECT_THAT(wrong.error().message, HasSubstr("io.orders is cut short or not what"));
  }
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  const auto folder_there = read_order_numbers(file);
  ASSERT_FALSE(folder_there);
  EXPECT_THAT(folder_there.error().message, HasSubstr("cannot be read"));
}

TEST_F(OrderKeeperTest, TheThreadWritesTheNewestAndTheEndWhatItHadNoTimeFor) {
  OrderKeeper keeper(file);
  EXPECT_EQ(keeper.end(), "");
  EXPECT_EQ(read(), OrderNumbers());
  {
    const Worker writing = keeper.writer([](const std::string&) {});
    keeper.keep(numbers);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (read() != numbers && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    EXPECT_EQ(read(), numbers);
  }
  keeper.keep({{"a", 1}});
  EXPECT_EQ(keeper.end(), "");
  EXPECT_EQ(read(), (OrderNumbers{{"a", 1}}));
}

TEST_F(OrderKeeperTest, SaysWhatItMeansThatNothingCanBeWritten) {
  ASSERT_TRUE(write_order_numbers(file, {}));
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  OrderKeeper keeper(file);
  keeper.keep(numbers);
  EXPECT_THAT(keeper.end(), HasSubstr("orders of today could be sent again: check the disk."));
}

}  // namespace
}  // namespace galilean::robot
