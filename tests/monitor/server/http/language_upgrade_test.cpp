// SPDX-License-Identifier: BSD-3-Clause
// Who may open the language server's WebSocket of the HTTP server, GET /lsp.
#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include "monitor/server/http/http_server.h"
#include "tests/monitor/server/lsp/editor_page.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using Refused = boost::beast::system_error;

class LanguageUpgradeTest : public testing::Test {
 protected:
  void listen(bool reads_freely) {
    server.emplace(io, HttpServer::ServerContext{Guard("127.0.0.1", {}),
                                                 Access({"viewer", "operator"}, reads_freely),
                                                 [](const HttpRequest&, const Respond&) {}, hub,
                                                 rounds, context, replay, worker});
    const auto listening = server->listen("127.0.0.1", 0);
    ASSERT_TRUE(listening) << listening.error().message;
    port = listening.value();
    thread = std::thread([this] { io.run(); });
  }
  void TearDown() override {
    io.stop();
    if (thread.joinable()) thread.join();
    worker.finish();
  }

  const TemporaryFolder folder;
  SteadyClock clock;
  Team team{clock};
  const Catalog installed{};
  foxglove::Hub hub{"monitor", [](std::uint32_t, bool) {}};
  RecordingFolder recordings{folder.path()};
  Playbacks playbacks;
  ReplayContext replay{recordings, playbacks};
  boost::asio::io_context io{1};
  SendRounds rounds{io};
  Worker worker{io};
  LanguageServerContext context{worker, team, installed, folder.path()};
  std::optional<HttpServer> server;
  std::uint16_t port = 0;
  std::thread thread;
};

TEST_F(LanguageUpgradeTest, WhereReadingIsNotFreeItTakesAToken) {
  listen(false);
  EXPECT_THROW(EditorPage{port}, Refused);
  EXPECT_THROW(EditorPage(port, "/lsp?token=wrong"), Refused);
  EXPECT_NO_THROW(EditorPage(port, "/lsp?robot=io&token=viewer"));
}

TEST_F(LanguageUpgradeTest, APageFromElsewhereIsRefused) {
  listen(true);
  EXPECT_THROW(EditorPage(port, "/lsp", "https://elsewhere.example"), Refused);
}

TEST_F(LanguageUpgradeTest, ThePageIsServed) {
  listen(true);
  EditorPage page(port);
  EXPECT_TRUE(page.ask("initialize", {{"capabilities", nullptr}}).contains("result"));
}

}  // namespace
}  // namespace galilean::monitor
