// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/operator_id.h"

#include <gtest/gtest.h>

#include "core/account.h"
#include "monitor/access/access.h"
#include "monitor/access/digest.h"

namespace galilean::monitor {
namespace {

TEST(OperatorIdTest, IsWhatItSaysOfItselfThenItsTokensNameThenWhereItIs) {
  EXPECT_EQ(operator_id("ada", "tab-1", "operator", "10.0.0.7"),
            (OperatorId{.name = "ada", .account = "operator", .client = "tab-1"}));
  EXPECT_EQ(operator_id("  ", "", "carols", "10.0.0.7").name, "carols");
  EXPECT_EQ(operator_id("", "", "operator", "10.0.0.7").name, "10.0.0.7");
  EXPECT_EQ(operator_id("", "", "operator", "127.0.0.1").name, user_name());
}

TEST(OperatorIdTest, TheNameThatItSaysIsShortAndCanBeShown) {
  const auto id = operator_id(std::string(5000, 'a') + "\x1b[2J", "1\n2", "operator", "10.0.0.7");
  EXPECT_EQ(id.name, std::string(kMostOperatorBytes, 'a'));
  EXPECT_EQ(operator_id("a\x1b[2J", "", "", "").name.find('\x1b'), std::string::npos);
  EXPECT_EQ(id.client.find('\n'), std::string::npos);
}

TEST(OperatorIdTest, APersonIsANameWithItsTokenFromEveryTab) {
  const OperatorId ada{.name = "ada", .account = "operator", .client = "1"};
  EXPECT_TRUE(ada.is_same_person({.name = "ada", .account = "operator", .client = "2"}));
  EXPECT_FALSE(ada.is_same_person({.name = "ada", .account = "adas", .client = "1"}));
  EXPECT_FALSE(ada.is_same_person({.name = "ben", .account = "operator", .client = "1"}));
}

TEST(OperatorIdTest, ATokenIsCalledByItsNameUntilItExpires) {
  std::int64_t now_s = 1000;
  Access access({.viewer = "view-view-view-vi", .operator_ = "oper-oper-oper-op"}, true,
                [&] { return now_s; });
  access.set_named({{.name = "carols",
                     .right = Right::kOperate,
                     .sha256 = digest_of("carols-token"),
                     .made_s = 0,
                     .expires_s = 2000}});
  EXPECT_EQ(access.account_by_digest(digest_of("oper-oper-oper-op")), "operator");
  EXPECT_EQ(access.account_by_digest(digest_of("view-view-view-vi")), "viewer");
  EXPECT_EQ(access.account_by_digest(digest_of("carols-token")), "carols");
  EXPECT_EQ(access.account_by_digest(digest_of("another")), "");
  now_s = 2000;
  EXPECT_EQ(access.account_by_digest(digest_of("carols-token")), "");
}

}  // namespace
}  // namespace galilean::monitor
