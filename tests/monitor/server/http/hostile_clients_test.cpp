// SPDX-License-Identifier: BSD-3-Clause
// Clients that take more than their part of the HTTP server: others are served, and the client is
// told why not.
#include <gmock/gmock.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <future>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "monitor/server/http/http_server.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using boost::asio::ip::tcp;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class HostileClientsTest : public testing::Test {
 protected:
  void SetUp() override {
    ServerLimits limits;
    limits.connections = limits.connections_of_loopback = 3;
    limits.reserved_connections = 1;
    limits.bodies_bytes = 200'000;
    limits.program.bytes = 150'000;
    server.emplace(io,
                   HttpServer::ServerContext{
                       Guard("127.0.0.1", {}), Access({"viewer", "operator"}, true),
                       [this](const HttpRequest& request, const Respond& respond) {
                         if (request.path == "/held") return hold(respond);
                         respond(text_response(std::to_string(request.body.size()), "text/plain"));
                       },
                       hub, rounds, language, replay, worker,
                       [](const std::string& path) {
                         return path == "/short" ? std::size_t{10} : std::size_t{150'000};
                       },
                       limits});
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

  /// Lets a request wait for its answer for ever.
  void hold(const Respond& respond) {
    held.push_back(respond);
    if (held.size() == 3) three_are_held.set_value();
  }
  tcp::socket& connect() {
    auto& socket = clients.emplace_back(mine);
    socket.connect({boost::asio::ip::address_v4::loopback(), port});
    return socket;
  }
  static void send(tcp::socket& socket, const std::string& text) {
    boost::asio::write(socket, boost::asio::buffer(text));
  }
  /// Everything that comes until the server closes the connection.
  static std::string read_to_the_end(tcp::socket& socket) {
    std::string answer;
    boost::system::error_code error;
    boost::asio::read(socket, boost::asio::dynamic_buffer(answer), error);
    return answer;
  }
  static std::string request(const std::string& path, const std::string& fields,
                             const std::string& body = {}) {
    return "POST " + path + " HTTP/1.1\r\nHost: localhost\r\n" + fields + "\r\n" + body;
  }
  /// The answer to a request that asks for the connection's end.
  std::string ask(const std::string& path, const std::string& fields,
                  const std::string& body = {}) {
    auto& socket = connect();
    send(socket, request(path, "Connection: close\r\n" + fields, body));
    return read_to_the_end(socket);
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
  LanguageServerContext language{worker, team, installed, folder.path()};
  std::optional<HttpServer> server;
  std::uint16_t port = 0;
  std::thread thread;
  boost::asio::io_context mine;
  std::deque<tcp::socket> clients;
  std::promise<void> three_are_held;
  std::vector<Respond> held;  ///< on the server's thread; it owns connections, so it goes first
};

TEST_F(HostileClientsTest, WhoOnlyWaitsMakesRoomForWhoAsks) {
  for (int i = 0; i < 3; ++i) connect();
  EXPECT_THAT(ask("/", ""), EndsWith("\r\n\r\n0"));
  EXPECT_THAT(read_to_the_end(clients.front()), IsEmpty()) << "the oldest was closed";
}

TEST_F(HostileClientsTest, WhereAllAreServedOnlyAnOperatorGetsIn) {
  for (int i = 0; i < 3; ++i) send(connect(), request("/held", ""));
  three_are_held.get_future().wait();
  EXPECT_THAT(ask("/", "Authorization: Bearer operator\r\n"), EndsWith("\r\n\r\n0"));
  const auto refused = ask("/", "Authorization: Bearer viewer\r\n");
  EXPECT_THAT(refused, StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(refused, HasSubstr("Retry-After: "));
  EXPECT_THAT(ask("/", "Authorization: Bearer operator\r\n"), EndsWith("\r\n\r\n0"));
  EXPECT_GE(hub.limit_counts()->count(Limit::kConnections), 3U);
}

TEST_F(HostileClientsTest, ABodyIsAsLongAsItsPathTakes) {
  EXPECT_THAT(ask("/short", "Content-Length: 10\r\n", std::string(10, 'x')),
              EndsWith("\r\n\r\n10"));
  for (const auto& [fields, body] : std::vector<std::pair<std::string, std::string>>{
           {"Content-Length: 400000\r\n", std::string(400'000, 'x')},
           {"Transfer-Encoding: chunked\r\n", "b\r\n" + std::string(11, 'x') + "\r\n0\r\n\r\n"}}) {
    const auto refused = ask("/short", fields, body);
    EXPECT_THAT(refused, StartsWith("HTTP/1.1 413 ")) << fields;
    EXPECT_THAT(refused, HasSubstr("larger than 10 bytes"));
  }
}

TEST_F(HostileClientsTest, LongBodiesOfAllAreBoundedAndShortOnesPass) {
  send(connect(), request("/", "Content-Length: 150000\r\n"));
  // This is answered after the first client's head was read, because there is one thread.
  EXPECT_THAT(ask("/", "Content-Length: 5\r\n", "12345"), EndsWith("\r\n\r\n5"));
  const auto refused = ask("/", "Content-Length: 150000\r\n", std::string(150'000, 'x'));
  EXPECT_THAT(refused, StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(refused, HasSubstr("Retry-After: "));
  EXPECT_THAT(ask("/", "Content-Length: 5\r\n", "12345"), EndsWith("\r\n\r\n5"));
  send(clients.front(), std::string(150'000, 'x'));
  std::string answer(15, ' ');
  boost::asio::read(clients.front(), boost::asio::buffer(answer));
  EXPECT_EQ(answer, "HTTP/1.1 200 OK");
}

TEST_F(HostileClientsTest, WhatIsNoHttpEndsTheConnectionAfterOneAnswer) {
  const std::string smuggled = "GET /hidden HTTP/1.1\r\nHost: localhost\r\n\r\n";
  for (const std::string& text :
       {request("/", "Transfer-Encoding: xchunked\r\n", smuggled),
        request("/", "Host: localhost\r\n", smuggled), request("/", "X: a\r\n b\r\n", smuggled),
        request("/", "Transfer-Encoding: chunked\r\nContent-Length: 3\r\n", smuggled),
        "GET / HTTP/1.1\nHost: localhost\n\n" + smuggled}) {
    auto& socket = connect();
    send(socket, text);
    socket.shutdown(tcp::socket::shutdown_send);
    const auto answers = read_to_the_end(socket);
    EXPECT_THAT(answers, testing::AnyOf(StartsWith("HTTP/1.1 400 "), StartsWith("HTTP/1.1 501 ")));
    EXPECT_THAT(answers, HasSubstr("Connection: close"));
    EXPECT_EQ(answers.find("HTTP/1.1 ", 1), answers.npos) << "there is one answer: " << answers;
  }
}

TEST_F(HostileClientsTest, AHeadIsBounded) {
  auto& long_head = connect();
  send(long_head, "GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(read_to_the_end(long_head), StartsWith("HTTP/1.1 431 "));
  std::string many;
  for (int i = 0; i < 200; ++i) many += "X: a\r\n";
  EXPECT_THAT(ask("/", many), StartsWith("HTTP/1.1 431 "));
}

TEST_F(HostileClientsTest, RequestsThatComeAtOnceAreAnsweredInTurn) {
  auto& socket = connect();
  send(socket, request("/", "Content-Length: 1\r\n", "x") +
                   request("/", "Transfer-Encoding: chunked\r\n", "2\r\nxy\r\n0\r\n\r\n") +
                   request("/", "Connection: close\r\nContent-Length: 3\r\n", "xyz"));
  const auto answers = read_to_the_end(socket);
  const auto first = answers.find("\r\n\r\n1"), second = answers.find("\r\n\r\n2");
  EXPECT_LT(first, second);
  EXPECT_NE(second, answers.npos) << answers;
  EXPECT_THAT(answers, EndsWith("\r\n\r\n3"));
}

}  // namespace
}  // namespace galilean::monitor
