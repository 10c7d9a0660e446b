// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

TEST(Tokens, AreMadeOnceForTheOwnersEyesAlone) {
  const TemporaryFolder folder;
  const auto made = open_tokens(folder / "new");
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_TRUE(made.value().are_new);
  EXPECT_EQ(made.value().operator_.size(), 40U);
  EXPECT_NE(made.value().operator_, made.value().viewer);
  for (const auto* name : {"viewer.token", "operator.token"}) {
    struct stat file {};
    ASSERT_EQ(stat((folder / "new" / name).c_str(), &file), 0);
    EXPECT_EQ(file.st_mode & 0777, 0600U) << name;
  }
  const auto again = open_tokens(folder / "new");
  EXPECT_FALSE(again.value().are_new);
  EXPECT_EQ(again.value().operator_, made.value().operator_);
}

TEST(Tokens, AFileWithoutATokenIsAnErrorAndNotAnOpenDoor) {
  const TemporaryFolder folder;
  std::ofstream(folder / "operator.token") << "\n";
  const auto opened = open_tokens(folder.path());
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find("remove it"), std::string::npos);
}

TEST(Access, TheOperatorSteersTheViewerReadsAndStrangersDoNeither) {
  const Access access({.viewer = "view-view-view-vi", .operator_ = "oper-oper-oper-op"}, false);
  EXPECT_EQ(access.right_of("oper-oper-oper-op"), Right::kOperate);
  EXPECT_EQ(access.right_of("view-view-view-vi"), Right::kRead);
  for (const auto* wrong : {"", "o", "oper-oper-oper-o", "oper-oper-oper-opp", "view-view-view-vj"})
    EXPECT_EQ(access.right_of(wrong), Right::kNone) << wrong;
}

TEST(Access, WhereOnlyThisMachineIsHeardReadingIsFree) {
  const Access access({.viewer = "view-view-view-vi", .operator_ = "oper-oper-oper-op"}, true);
  EXPECT_EQ(access.right_of(""), Right::kRead);
  EXPECT_EQ(access.right_of("wrong"), Right::kRead);
  EXPECT_EQ(access.right_of("oper-oper-oper-op"), Right::kOperate);
  for (const auto* near : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
    EXPECT_TRUE(is_loopback(near)) << near;
  for (const auto* far : {"0.0.0.0", "192.168.1.5", "::", "1270.0.0.1", ""})
    EXPECT_FALSE(is_loopback(far)) << far;
}

}  // namespace
}  // namespace galilean::monitor
