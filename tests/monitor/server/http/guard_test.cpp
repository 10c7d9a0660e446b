// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/guard.h"

#include <gtest/gtest.h>

#include "monitor/server/http/page_files.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

bool passes(const Guard& guard, const std::string& host, const std::string& origin = {}) {
  HttpRequest request;
  request.host = host;
  request.origin = origin;
  return guard.admit(request).ok();
}

TEST(Guard, LetsLoopbackNamesThroughOnAnyPort) {
  const Guard guard("127.0.0.1", {});
  for (const auto* host :
       {"localhost:8080", "LOCALHOST", "127.0.0.1:9000", "127.0.0.1", "[::1]:8080"})
    EXPECT_TRUE(passes(guard, host)) << host;
}

TEST(Guard, RefusesNamesThatDnsMayHaveRebound) {
  const Guard guard("127.0.0.1", {});
  for (const auto* host : {"evil.example", "evil.example:8080", "", "localhost.evil.example",
                           "192.168.1.5", "127.0.0.1.evil.example", "[", "localhost@evil"})
    EXPECT_FALSE(passes(guard, host)) << host;
}

TEST(Guard, AServerOnAllAddressesAnswersForAddressesButNotForNames) {
  const Guard guard("0.0.0.0", {});
  EXPECT_TRUE(passes(guard, "192.168.1.5:8080"));
  EXPECT_FALSE(passes(guard, "robots.example:8080"));
}

TEST(Guard, ANameOfTheCertificateIsItsOwn) {
  Guard guard("0.0.0.0", {}, "https");
  guard.answer_also_for([](const std::string& name) { return name == "robots.example"; });
  EXPECT_TRUE(passes(guard, "Robots.example:8080", "https://robots.example:8080"));
  EXPECT_FALSE(passes(guard, "robots.example:8080", "http://robots.example:8080"));
  for (const auto* host : {"evil.example", "", "robots.example.evil.example", "["})
    EXPECT_FALSE(passes(guard, host)) << host;
}

TEST(Guard, OnlyItsOwnPageAndAllowedOnesMayAsk) {
  const Guard guard("127.0.0.1", {"https://studio.example"});
  EXPECT_TRUE(passes(guard, "localhost:8080", "http://localhost:8080"));
  EXPECT_TRUE(passes(guard, "localhost:8080", "https://studio.example"));
  EXPECT_FALSE(passes(guard, "localhost:8080", "http://localhost:3000"));
  EXPECT_FALSE(passes(guard, "localhost:8080", "https://evil.example"));
  EXPECT_FALSE(passes(guard, "localhost:8080", "null"));
}

TEST(Guard, APageOfTheSameHostByAnotherSchemeIsAStranger) {
  const Guard guard("127.0.0.1", {});
  EXPECT_TRUE(passes(guard, "LocalHost:8080", "HTTP://localhost:8080"));
  for (const auto* origin : {"https://localhost:8080", "ws://localhost:8080", "localhost:8080",
                             "//localhost:8080", "x-http://localhost:8080", "http://", "://"})
    EXPECT_FALSE(passes(guard, "localhost:8080", origin)) << origin;
  const Guard encrypted("127.0.0.1", {}, "https");
  EXPECT_TRUE(passes(encrypted, "localhost:8080", "https://localhost:8080"));
  EXPECT_FALSE(passes(encrypted, "localhost:8080", "http://localhost:8080"));
}

TEST(Guard, DesktopProgramsWhosePagesAreFilesMayAsk) {
  const Guard guard("127.0.0.1", {});
  EXPECT_TRUE(passes(guard, "localhost:8080", "file://"));
  EXPECT_FALSE(passes(guard, "evil.example", "file://"));
  EXPECT_FALSE(passes(guard, "localhost:8080", "file://evil.example"));
}

TEST(Guard, RecordingsAreForPagesOfAnySiteButTheirHostIsChecked) {
  const Guard guard("127.0.0.1", {"https://studio.example"});
  HttpRequest request{.path = "/recordings/run.mcap", .host = "localhost:8080"};
  request.origin = "https://viewer.example";
  EXPECT_TRUE(guard.admit(request));
  EXPECT_TRUE(guard.is_of_stranger(request)) << "it needs a token";
  request.path = "/api/recordings";
  EXPECT_FALSE(guard.admit(request));
  request.path = "/recordings/run.mcap";
  for (const char* origin : {"https://studio.example", "http://localhost:8080", "file://", ""}) {
    request.origin = origin;
    EXPECT_FALSE(guard.is_of_stranger(request)) << origin;
  }
  request.host = "evil.example";
  EXPECT_FALSE(guard.admit(request));
}

TEST(PageFiles, WithoutAPageItSaysHowToBuildOne) {
  const PageFiles page("/nonexistent");
  HttpRequest request;
  request.path = "/";
  const auto response = page.get(request);
  EXPECT_EQ(response.status, 200);
  EXPECT_NE(response.body->find("npm run build"), std::string::npos);
}

TEST(PageFiles, KnowsWhatTheBrowserHasAlready) {
  const PageFiles page("/nonexistent");
  HttpRequest request;
  request.path = "/index.html";
  const auto first = page.get(request);
  request.if_none_match = first.headers.at(0).second;
  EXPECT_EQ(page.get(request).status, 304);
  request.path = "/../etc/passwd";
  EXPECT_EQ(page.get(request).status, 404);
}

TEST(PercentDecoding, TakesEscapesAndLeavesTheRest) {
  EXPECT_EQ(percent_decoded("/a%20b%2Fc"), "/a b/c");
  EXPECT_EQ(percent_decoded("%"), "%");
  EXPECT_EQ(percent_decoded("%g1%4"), "%g1%4");
}

TEST(Query, GivesTheValueOfAName) {
  EXPECT_EQ(query_value("/lsp?robot=io&token=a%20b", "token"), "a b");
  EXPECT_EQ(query_value("/lsp?robot=io&token=a%20b", "robot"), "io");
  EXPECT_EQ(query_value("/lsp?xrobot=io", "robot"), "");
  EXPECT_EQ(query_value("/lsp?robot", "robot"), "");
  EXPECT_EQ(query_value("/robot=io", "robot"), "");
}

}  // namespace
}  // namespace galilean::monitor
