// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "monitor/access/digest.h"
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

TEST(Access, ANamedTokenGivesItsRoleUntilItExpiresOrIsTakenOut) {
  std::int64_t now_s = 1000;
  Access access({.viewer = "view-view-view-vi", .operator_ = "oper-oper-oper-op"}, false,
                [&] { return now_s; });
  const auto named = [](const std::string& name, Right right, std::optional<std::int64_t> expires) {
    return NamedToken{
        .name = name, .right = right, .sha256 = digest_of(name), .made_s = 0, .expires_s = expires};
  };
  access.set_named({named("anna", Right::kRead, {}), named("bert", Right::kOperate, 1010)});
  EXPECT_EQ(access.right_of("anna"), Right::kRead);
  EXPECT_EQ(access.right_of("bert"), Right::kOperate);
  EXPECT_EQ(access.right_of(digest_of("bert")), Right::kNone) << "what is stored opens nothing";
  now_s = 1010;
  EXPECT_EQ(access.right_of("bert"), Right::kNone);
  access.set_named({});
  EXPECT_EQ(access.right_of("anna"), Right::kNone);
  EXPECT_EQ(access.right_of("oper-oper-oper-op"), Right::kOperate) << "the files' tokens stay";
  EXPECT_EQ(access.right_of("view-view-view-vi"), Right::kRead);
}

TEST(Digest, IsComparedAsAWhole) {
  EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_TRUE(is_same_digest(digest_of("abc"), digest_of("abc")));
  auto other = digest_of("abc");
  other.back() = 'e';
  EXPECT_FALSE(is_same_digest(digest_of("abc"), other));
  EXPECT_FALSE(is_same_digest(digest_of("abc"), ""));
  EXPECT_FALSE(is_same_digest(digest_of("abc"), digest_of("abc").substr(1)));
}

}  // namespace
}  // namespace galilean::monitor
