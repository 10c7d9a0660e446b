// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/page_policy.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

/// Of `script-src` alone.
std::string script_sources(std::string_view html) {
  const std::string policy = page_policy(html);
  const std::string name = "script-src ";
  const auto begin = policy.find(name) + name.size();
  return policy.substr(begin, policy.find(';', begin) - begin);
}

TEST(PagePolicy, APageWithoutScriptsInsideItRunsItsOwnFilesOnly) {
  EXPECT_EQ(script_sources(R"(<script src="/main.js"></script>)"), "'self'");
}

// The hashes are those that `openssl dgst -sha256 -binary | base64` prints.
TEST(PagePolicy, NamesEachScriptInsideThePageByItsHash) {
  EXPECT_EQ(script_sources("<script>alert('Hello, world.');</script><p><script>2</script>"),
            "'self' 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng=' "
            "'sha256-1HNeOiZeFu7gP1lxi5tdAwGcB9i2xR+Q2jpmbuwTqzU='");
}

TEST(PagePolicy, ThePageConnectsToItsOwnHostAlone) {
  EXPECT_EQ(connect_policy("localhost:8080"),
            "; connect-src 'self' ws://localhost:8080 wss://localhost:8080");
  for (const auto* strange : {"", "[::1]:8080", "localhost:8080; script-src *", "a b", "a,b",
                              "localhost\n", "*", "a/'b'"})
    EXPECT_EQ(connect_policy(strange), "; connect-src 'self'") << strange;
}

TEST(PagePolicy, NoDirectiveLetsEveryHostOrAnotherSitesFrameIn) {
  const std::string policy = page_policy("") + connect_policy("localhost:8080");
  for (const auto* directive : {"base-uri 'none'", "form-action 'none'", "frame-ancestors 'none'",
                                "object-src 'none'", "default-src 'self'"})
    EXPECT_NE(policy.find(directive), policy.npos) << directive;
  for (const auto* whole_scheme : {" ws:;", " ws: ", " wss:;", " wss: ", " http:", " https:", "*"})
    EXPECT_EQ(policy.find(whole_scheme), policy.npos) << whole_scheme;
}

TEST(PagePolicy, AScriptThatDoesNotEndIsNone) {
  EXPECT_EQ(script_sources("<script>alert("), "'self'");
  EXPECT_EQ(script_sources("<script>"), "'self'");
}

}  // namespace
}  // namespace galilean::monitor
