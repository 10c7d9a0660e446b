// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/program_keeper.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/robot/restart/own_program.h"
#include "tests/temporary_folder.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

class ProgramKeeperTest : public testing::Test {
 protected:
  [[nodiscard]] KeptProgram read() const {
    const auto kept = read_kept_program(file, "io");
    if (!kept || !kept.value()) return {};
    return *kept.value();
  }
  /// Waits until `done` is true, for at most 10 s. Returns whether it became true.
  static bool becomes(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    return done();
  }

  TemporaryFolder folder;
  std::filesystem::path file = kept_program_file(folder.path(), "io", 0);
  bhdl::Program first = own_program("first.bhdl", "first");
  bhdl::Program second = own_program("second.bhdl", "second");
  std::mutex mutex;
  std::string told = "nothing yet";  ///< guarded by mutex
  ProgramKeeper::Tell tell = [this](const std::string& problem) {
    const std::lock_guard lock(mutex);
    told = problem;
  };
  std::string said() {
    const std::lock_guard lock(mutex);
    return told;
  }
};

TEST_F(ProgramKeeperTest, FromTheBeginningToTheEndTheFileSaysThatTheRobotProgramRuns) {
  ProgramKeeper keeper(file, "io");
  EXPECT_EQ(keeper.begin(first, false), "");
  EXPECT_TRUE(read().running);
  EXPECT_FALSE(read().pushed);
  EXPECT_EQ(read().hash, first.hash);
  {
    const Worker writing = keeper.writer(tell);
    keeper.keep(second, true);
    EXPECT_TRUE(becomes([&] { return read().hash == second.hash; }));
    EXPECT_TRUE(read().running);
    EXPECT_TRUE(read().pushed);
    EXPECT_TRUE(becomes([&] { return said().empty(); }));
  }
  EXPECT_EQ(keeper.end(), "");
  EXPECT_FALSE(read().running);
  EXPECT_EQ(read().hash, second.hash);
}

TEST_F(ProgramKeeperTest, WhatOperatorsOrderedIsKeptBesideTheProgram) {
  const KeptOrders of_before{"anna", true};
  const KeptOrders newest{"balch", false};
  ProgramKeeper keeper(file, "io");
  EXPECT_EQ(keeper.begin(first, true, of_before), "");
  EXPECT_EQ(read().orders, of_before) << "a second death ends them no more than the first";
  const Worker writing = keeper.writer(tell);
  keeper.keep_orders(newest);
  EXPECT_TRUE(becomes([&] { return read().orders == newest; }));
  EXPECT_EQ(read().hash, first.hash);
  EXPECT_TRUE(read().pushed);
  keeper.keep(second, true);
  EXPECT_TRUE(becomes([&] { return read().hash == second.hash; }));
  EXPECT_EQ(read().orders, newest);
}

TEST_F(ProgramKeeperTest, WhatTheThreadHadNoTimeForIsWrittenAtTheEnd) {
  ProgramKeeper keeper(file, "io");
  EXPECT_EQ(keeper.begin(first, false), "");
  keeper.keep(second, true);
  EXPECT_EQ(read().hash, first.hash);
  EXPECT_EQ(keeper.end(), "");
  EXPECT_EQ(read().hash, second.hash);
}

TEST_F(ProgramKeeperTest, WithoutAnEndItDied) {
  {
    ProgramKeeper keeper(file, "io");
    EXPECT_EQ(keeper.begin(first, false), "");
    const Worker writing = keeper.writer(tell);
  }
  EXPECT_TRUE(read().running);
}

TEST_F(ProgramKeeperTest, ADiskThatTakesNothingIsSaidAndStopsNobody) {
  std::ofstream(folder / "robots") << "no folder";
  ProgramKeeper keeper(file, "io");
  EXPECT_THAT(keeper.begin(first, false), HasSubstr("cannot be written"));
  {
    const Worker writing = keeper.writer(tell);
    keeper.keep(second, true);
    EXPECT_TRUE(becomes([&] { return said().find("cannot be written") != std::string::npos; }));
    std::filesystem::remove(folder / "robots");
    keeper.keep(first, true);
    EXPECT_TRUE(becomes([&] { return said().empty(); })) << "it is well again";
  }
  EXPECT_EQ(read().hash, first.hash);
}

}  // namespace
}  // namespace galilean::robot
