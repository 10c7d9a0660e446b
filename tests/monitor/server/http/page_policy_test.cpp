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

TEST(PagePolicy, AScriptThatDoesNotEndIsNone) {
  EXPECT_EQ(script_sources("<script>alert("), "'self'");
  EXPECT_EQ(script_sources("<script>"), "'self'");
}

}  // namespace
}  // namespace galilean::monitor
