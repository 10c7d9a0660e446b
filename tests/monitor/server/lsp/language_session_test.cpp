// SPDX-License-Identifier: BSD-3-Clause
// The language server in the monitor, as the page's editor meets it: over a WebSocket.
#include "monitor/server/lsp/language_session.h"

#include <gmock/gmock.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/monitor/server/lsp/editor_page.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using nlohmann::json;
using testing::HasSubstr;

Catalog catalog_with(const std::string& component) {
  return {{{component, ComponentKind::kVariable, "A variable.", {}}}};
}

/// Accepts WebSockets of the language server alone, on an io_context.
class Listener {
 public:
  Listener(asio::io_context& io, LanguageServerContext& context)
      : acceptor_(io, {asio::ip::address_v4::loopback(), 0}), rounds_(io), context_(context) {
    accept();
  }
  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  void accept() {
    acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
      if (error) return;
      beast::flat_buffer buffer;
      beast::http::request<beast::http::string_body> upgrade;
      beast::http::read(socket, buffer, upgrade);
      serve_language(std::move(socket), upgrade, rounds_, context_);
      accept();
    });
  }

  tcp::acceptor acceptor_;
  SendRounds rounds_;
  LanguageServerContext& context_;
};

class LanguageSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder / "parts.bhdl") << "variables: built_in: name: \"shared\" end\n";
  }
  void serve() {
    thread = std::thread([this] { io.run(); });
  }
  void TearDown() override {
    io.stop();
    if (thread.joinable()) thread.join();
    worker.finish();
  }

  void publish_catalog(const std::string& robot, const std::string& component) {
    msg::Catalog catalog;
    catalog.robot = robot;
    catalog.json = catalog_to_json(catalog_with(component));
    team.note(catalog);
  }

  const TemporaryFolder folder;
  SteadyClock clock;
  Team team{clock};
  const Catalog installed = catalog_with("built_in");
  asio::io_context io{1};
  Worker worker{io};
  LanguageServerContext context{worker, team, installed, folder.path()};
  Listener listener{io, context};
  const std::uint16_t port = listener.port();
  std::thread thread;
};

TEST_F(LanguageSessionTest, ProblemsComeUnaskedAndIncludesAreTheLibrarys) {
  serve();
  EditorPage page(port);
  page.start("include \"parts.bhdl\"\ninclude \"none.bhdl\"\nstates: state: name: \"a\" end end\n");
  const json published = page.next();
  EXPECT_EQ(published["method"], "textDocument/publishDiagnostics");
  ASSERT_EQ(published["params"]["diagnostics"].size(), 1U) << published.dump(1);
  EXPECT_THAT(published["params"]["diagnostics"][0]["message"], HasSubstr("none.bhdl"));
}

TEST_F(LanguageSessionTest, NothingAboveTheLibraryIsRead) {
  std::ofstream(folder / "secret.bhdl") << "variables: built_in: name: \"s\" end\n";
  std::filesystem::create_directories(folder / "library");
  LanguageServerContext inner{worker, team, installed, folder / "library"};
  const Listener other{io, inner};
  serve();
  EditorPage page(other.port());
  page.start("include \"../secret.bhdl\"\nstates: state: name: \"a\" end end\n");
  EXPECT_EQ(page.next()["params"]["diagnostics"][0]["code"], "include/not-found");
}

TEST_F(LanguageSessionTest, TheCatalogIsARobotsWhereOneIsKnown) {
  publish_catalog("ganymede", "of_ganymede");
  publish_catalog("io", "of_io");
  serve();
  EditorPage first(port);
  first.start("variables:\n");
  EXPECT_THAT(first.proposed(), HasSubstr("of_ganymede"));
  EditorPage named(port, "/lsp?robot=io");
  named.start("variables:\n");
  EXPECT_THAT(named.proposed(), HasSubstr("of_io"));
}

TEST_F(LanguageSessionTest, EditorsThatAskAtTheSameTimeGetTheirOwnAnswers) {
  publish_catalog("ganymede", "of_ganymede");
  publish_catalog("io", "of_io");
  serve();
  const auto ask = [this](const std::string& robot) {
    EditorPage page(port, "/lsp?robot=" + robot);
    page.start("variables:\n");
    for (int i = 0; i < 20; ++i) EXPECT_THAT(page.proposed(), HasSubstr("of_" + robot));
  };
  std::thread other(ask, "ganymede");
  ask("io");
  other.join();
}

TEST_F(LanguageSessionTest, OnlySoManyEditorsAreServedAtOnce) {
  serve();
  std::deque<EditorPage> pages;
  for (std::size_t i = 0; i < kMostLanguageSessions; ++i) pages.emplace_back(port);
  for (auto& page : pages) page.start("variables:\n");
  EditorPage one_more(port);
  EXPECT_THROW((void)one_more.next(), boost::system::system_error);
  EXPECT_THAT(pages.front().proposed(), HasSubstr("built_in"));
}

TEST_F(LanguageSessionTest, WithoutARobotItIsTheInstalledOne) {
  serve();
  EditorPage page(port, "/lsp?robot=nobody");
  page.start("variables:\n");
  EXPECT_THAT(page.proposed(), HasSubstr("built_in"));
}

TEST_F(LanguageSessionTest, WhatIsNoMessageIsAnsweredAndTheNextOneHeard) {
  serve();
  EditorPage page(port);
  page.send("a text");
  EXPECT_EQ(page.next()["error"]["code"], -32600);
  EXPECT_TRUE(page.ask("initialize", {{"capabilities", nullptr}}).contains("result"));
}

TEST_F(LanguageSessionTest, ExitEndsTheConnection) {
  serve();
  EditorPage page(port);
  page.start("");
  (void)page.ask("shutdown", nullptr);
  page.send({{"jsonrpc", "2.0"}, {"method", "exit"}});
  EXPECT_THROW(for (;;)(void) page.next(), beast::system_error);
}

}  // namespace
}  // namespace galilean::monitor
