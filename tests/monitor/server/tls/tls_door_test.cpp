// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/tls/tls_door.h"

#include <gmock/gmock.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <future>
#include <thread>

#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
using asio::ip::tcp;
using boost::system::error_code;
using testing::HasSubstr;

/// A door whose connections are given to the test, which reads and writes the sessions' sockets in
/// its own thread.
class TlsDoorTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto files = own_certificate(folder.path());
    ASSERT_TRUE(ensure_own_certificate(files));
    auto opened = TlsDoor::open(files);
    ASSERT_TRUE(opened) << opened.error().message;
    door = std::move(opened).value();
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      if (error) return;
      door->enter(std::move(socket), [this](tcp::socket inner, const std::string& from) {
        address = from;
        // The test's thread waits with it, which asio's own handlers do not touch any more.
        admitted.set_value(std::move(inner));
      });
    });
    thread = std::thread([this] { io.run(); });
    plain.connect(acceptor.local_endpoint());
  }
  void TearDown() override {
    io.stop();
    thread.join();
  }
  tcp::socket session() { return admitted.get_future().get(); }

  const TemporaryFolder folder;
  std::string address;
  std::promise<tcp::socket> admitted;
  std::shared_ptr<TlsDoor> door;
  asio::io_context io{1};
  tcp::acceptor acceptor{io, tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  std::thread thread;

  asio::io_context mine;
  ssl::context trusting{ssl::context::tls_client};
  tcp::socket plain{mine};
};

TEST_F(TlsDoorTest, CarriesMoreThanItsBuffersInBothDirections) {
  ssl::stream<tcp::socket> client(std::move(plain), trusting);
  client.handshake(ssl::stream_base::client);
  auto inner = session();
  EXPECT_EQ(address, "127.0.0.1");
  std::string sent(4 << 20, 'a');
  for (std::size_t i = 0; i < sent.size(); i += 997) sent[i] = static_cast<char>('a' + i % 26);
  std::string heard(sent.size(), ' '), answered(sent.size(), ' ');
  std::thread echo([&] {
    asio::read(inner, asio::buffer(heard));
    asio::write(inner, asio::buffer(heard));
  });
  asio::write(client, asio::buffer(sent));
  asio::read(client, asio::buffer(answered));
  echo.join();
  EXPECT_TRUE(heard == sent);
  EXPECT_TRUE(answered == sent);
}

TEST_F(TlsDoorTest, WhatASessionSentBeforeItClosedArrivesAndThenTheEnd) {
  ssl::stream<tcp::socket> client(std::move(plain), trusting);
  client.handshake(ssl::stream_base::client);
  {
    auto inner = session();
    asio::write(inner, asio::buffer(std::string(100'000, 'x')));
  }
  std::string all;
  error_code end;
  asio::read(client, asio::dynamic_buffer(all), end);
  EXPECT_EQ(end, asio::error::eof) << "a goodbye, and no cut: " << end.message();
  EXPECT_EQ(all.size(), 100'000U);
}

TEST_F(TlsDoorTest, ASessionSeesThatItsClientIsGone) {
  {
    ssl::stream<tcp::socket> client(std::move(plain), trusting);
    client.handshake(ssl::stream_base::client);
  }
  auto inner = session();
  char byte = 0;
  error_code end;
  asio::read(inner, asio::buffer(&byte, 1), end);
  EXPECT_EQ(end, asio::error::eof);
}

TEST_F(TlsDoorTest, KnowsTheNamesOfItsCertificateAndWhetherItIsOfNow) {
  EXPECT_TRUE(door->is_named("localhost"));
  for (const std::string name : {"", "evil.example", "localhost.evil.example", "127.0.0.1"})
    EXPECT_FALSE(door->is_named(name)) << name;
  EXPECT_EQ(door->objection(), "");
}

TEST_F(TlsDoorTest, WhoSpeaksPlainHttpIsToldSoInOneSentence) {
  asio::write(plain, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")));
  plain.shutdown(tcp::socket::shutdown_send);
  std::string answer;
  error_code end;
  asio::read(plain, asio::dynamic_buffer(answer), end);
  EXPECT_EQ(end, asio::error::eof) << end.message();
  EXPECT_THAT(answer, testing::StartsWith("HTTP/1.1 400 Bad Request\r\n"));
  EXPECT_THAT(answer, HasSubstr("This monitor speaks TLS here: open https:// and not http://."));
}

TEST_F(TlsDoorTest, OldTlsIsRefused) {
  ssl::context old(ssl::context::tlsv11_client);
  SSL_CTX_set_security_level(old.native_handle(), 0);  // else OpenSSL does not even offer it
  ssl::stream<tcp::socket> client(std::move(plain), old);
  error_code refused;
  client.handshake(ssl::stream_base::client, refused);
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace galilean::monitor
