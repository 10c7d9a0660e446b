// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/open_sockets.h"

#include <gtest/gtest.h>

#include "monitor/access/digest.h"

namespace galilean::monitor {
namespace {

class FakeSession final : public Revocable {
 public:
  void revoke(const std::string&) override { ++revoked; }
  void cut() override { ++cuts; }
  int revoked = 0, cuts = 0;
};

class OpenSocketsTest : public testing::Test {
 protected:
  std::shared_ptr<FakeSession> open(const std::string& token, Right right) {
    auto session = std::make_shared<FakeSession>();
    sockets.add(digest_of(token), right, session);
    return session;
  }
  void name(const std::string& token, Right right, std::optional<std::int64_t> expires_s = {}) {
    named.push_back({.name = token,
                     .right = right,
                     .sha256 = digest_of(token),
                     .made_s = now_s,
                     .expires_s = expires_s});
    access.set_named(named);
  }

  std::int64_t now_s = 1000;
  std::vector<NamedToken> named;
  Access access{{.viewer = "viewer-of-file", .operator_ = "operator-of-file"}, true, [this] {
                  return now_s;
                }};
  OpenSockets sockets;
};

TEST_F(OpenSocketsTest, OneWhoseTokenIsRevokedIsClosedAndThenCut) {
  name("anna", Right::kRead);
  name("bert", Right::kOperate);
  const auto anna = open("anna", Right::kRead), bert = open("bert", Right::kOperate);
  const auto own = open("operator-of-file", Right::kOperate);
  sockets.end_withdrawn(access);
  EXPECT_EQ(anna->revoked + bert->revoked + own->revoked, 0);
  named.erase(named.begin());
  access.set_named(named);
  sockets.end_withdrawn(access);
  EXPECT_EQ(anna->revoked, 1) << "though reading is free";
  EXPECT_EQ(anna->cuts, 0) << "it may close by itself";
  EXPECT_EQ(sockets.ended(), 1U);
  for (int i = 0; i < 3; ++i) sockets.end_withdrawn(access);
  EXPECT_EQ(anna->revoked, 1);
  EXPECT_EQ(anna->cuts, 1);
  EXPECT_EQ(bert->revoked + own->revoked, 0);
}

TEST_F(OpenSocketsTest, OneWhoseTokenExpiresIsClosedInThatSecond) {
  name("anna", Right::kRead, 1005);
  const auto anna = open("anna", Right::kRead);
  now_s = 1004;
  sockets.end_withdrawn(access);
  EXPECT_EQ(anna->revoked, 0);
  now_s = 1005;
  sockets.end_withdrawn(access);
  EXPECT_EQ(anna->revoked, 1);
}

TEST_F(OpenSocketsTest, AnOperatorWhoBecomesAViewerIsClosed) {
  name("bert", Right::kOperate);
  const auto bert = open("bert", Right::kOperate);
  named[0].right = Right::kRead;
  access.set_named(named);
  sockets.end_withdrawn(access);
  EXPECT_EQ(bert->revoked, 1);
}

TEST_F(OpenSocketsTest, ThoseThatAreGoneAreForgotten) {
  name("anna", Right::kRead);
  (void)open("anna", Right::kRead);
  access.set_named({});
  sockets.end_withdrawn(access);
  EXPECT_EQ(sockets.ended(), 0U);
}

}  // namespace
}  // namespace galilean::monitor
