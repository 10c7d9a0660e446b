// SPDX-License-Identifier: BSD-3-Clause
// The language server in the monitor, as the page's editor meets it: over a WebSocket.
#include "monitor/server/lsp/language_session.h"

#include <gmock/gmock.h>

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "monitor/server/http/http_server.h"
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

class LanguageSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder / "parts.bhdl") << "variables: built_in: name: \"shared\" end\n";
    const auto listening = server.listen("127.0.0.1", 0);
    ASSERT_TRUE(listening) << listening.error().message;
    port = listening.value();
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
  foxglove::Hub hub{"monitor", [](std::uint32_t, bool) {}};
  asio::io_context io{1};
  SendRounds rounds{io};
  Worker worker{io};
  LanguageServerContext context{worker, team, installed, folder.path()};
  HttpServer::ServerContext context_of(LanguageServerContext& of, bool reads_freely) {
    return {Guard("127.0.0.1", {}),
            Access({"viewer", "operator"}, reads_freely),
            [](const HttpRequest&, const Respond&) {},
            hub,
            rounds,
            of};
  }
  HttpServer server{io, context_of(context, true)};
  std::uint16_t port = 0;
  std::thread thread;
};

/// An editor in a browser.
class Page {
 public:
  explicit Page(std::uint16_t port, const std::string& target = "/lsp",
                const std::string& origin = {})
      : stream_(io_) {
    beast::get_lowest_layer(stream_).connect({asio::ip::address_v4::loopback(), port});
    stream_.set_option(beast::websocket::stream_base::decorator([=](auto& message) {
      if (!origin.empty()) message.set(beast::http::field::origin, origin);
    }));
    stream_.handshake("127.0.0.1:" + std::to_string(port), target);
  }
  void send(const json& message) { stream_.write(asio::buffer(message.dump())); }
  json next() {
    beast::flat_buffer buffer;
    stream_.read(buffer);
    return json::parse(beast::buffers_to_string(buffer.data()));
  }
  json ask(const std::string& method, const json& params) {
    send({{"jsonrpc", "2.0"}, {"id", ++last_id_}, {"method", method}, {"params", params}});
    for (;;)
      if (auto answer = next(); answer.value("id", 0) == last_id_) return answer;
  }
  void start(const std::string& text) {
    (void)ask("initialize", {{"capabilities", json::object()}});
    send({{"jsonrpc", "2.0"},
          {"method", "textDocument/didOpen"},
          {"params",
           {{"textDocument", {{"uri", "file:///mine.bhdl"}, {"version", 1}, {"text", text}}}}}});
  }
  /// What may stand at the text's beginning of a component.
  std::string proposed() {
    return ask("textDocument/completion",
               {{"textDocument", {{"uri", "file:///mine.bhdl"}}},
                {"position", {{"line", 1}, {"character", 0}}}})["result"]["items"]
        .dump();
  }

 private:
  asio::io_context io_;
  beast::websocket::stream<tcp::socket> stream_;
  int last_id_ = 0;
};

TEST_F(LanguageSessionTest, ProblemsComeUnaskedAndIncludesAreTheLibrarys) {
  serve();
  Page page(port);
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
  HttpServer other{io, context_of(inner, true)};
  const auto listening = other.listen("127.0.0.1", 0);
  ASSERT_TRUE(listening);
  serve();
  Page page(listening.value());
  page.start("include \"../secret.bhdl\"\nstates: state: name: \"a\" end end\n");
  EXPECT_EQ(page.next()["params"]["diagnostics"][0]["code"], "include/not-found");
}

TEST_F(LanguageSessionTest, WhereReadingIsNotFreeItTakesAToken) {
  HttpServer other{io, context_of(context, false)};
  const auto listening = other.listen("127.0.0.1", 0);
  ASSERT_TRUE(listening);
  serve();
  EXPECT_THROW(Page(listening.value()), beast::system_error);
  EXPECT_THROW(Page(listening.value(), "/lsp?token=wrong"), beast::system_error);
  EXPECT_NO_THROW(Page(listening.value(), "/lsp?robot=io&token=viewer"));
}

TEST_F(LanguageSessionTest, TheCatalogIsARobotsWhereOneIsKnown) {
  publish_catalog("ganymede", "of_ganymede");
  publish_catalog("io", "of_io");
  serve();
  Page first(port);
  first.start("variables:\n");
  EXPECT_THAT(first.proposed(), HasSubstr("of_ganymede"));
  Page named(port, "/lsp?robot=io");
  named.start("variables:\n");
  EXPECT_THAT(named.proposed(), HasSubstr("of_io"));
}

TEST_F(LanguageSessionTest, WithoutARobotItIsTheInstalledOne) {
  serve();
  Page page(port, "/lsp?robot=nobody");
  page.start("variables:\n");
  EXPECT_THAT(page.proposed(), HasSubstr("built_in"));
}

TEST_F(LanguageSessionTest, WhatIsNoMessageIsAnsweredAndTheNextOneHeard) {
  serve();
  Page page(port);
  page.send("a text");
  EXPECT_EQ(page.next()["error"]["code"], -32600);
  EXPECT_TRUE(page.ask("initialize", {{"capabilities", nullptr}}).contains("result"));
}

TEST_F(LanguageSessionTest, APageFromElsewhereIsRefused) {
  serve();
  EXPECT_THROW(Page(port, "/lsp", "https://elsewhere.example"), beast::system_error);
}

TEST_F(LanguageSessionTest, ExitEndsTheConnection) {
  serve();
  Page page(port);
  page.start("");
  (void)page.ask("shutdown", nullptr);
  page.send({{"jsonrpc", "2.0"}, {"method", "exit"}});
  EXPECT_THROW(for (;;)(void) page.next(), beast::system_error);
}

}  // namespace
}  // namespace galilean::monitor
