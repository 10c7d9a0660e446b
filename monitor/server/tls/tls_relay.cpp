// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/tls/tls_relay.h"

#include <sys/socket.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <utility>

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::seconds kLongestHandshake{10};
constexpr std::chrono::seconds kLongestWrite{30};
constexpr std::chrono::seconds kLongestGoodbye{10};
/// What a session may have sent that the client has not read: little, so that messages which newer
/// ones supersede wait in the session, where that is done.
constexpr int kPairBytes = 64 << 10;

/// Returns the answer to a client that speaks plain HTTP.
const std::string& plain_answer() {
  static const std::string kBody =
      R"({"title":"Bad Request","status":400,"detail":"This monitor speaks TLS here: open https:// and not http://."})";
  static const std::string kAnswer =
      "HTTP/1.1 400 Bad Request\r\nContent-Type: application/problem+json\r\nConnection: close\r\n"
      "Content-Length: " +
      std::to_string(kBody.size()) + "\r\n\r\n" + kBody;
  return kAnswer;
}

}  // namespace

TlsRelay::TlsRelay(tcp::socket client, asio::ssl::context& context, std::shared_ptr<void> place,
                   Admit admit)
    : client_(std::move(client), context),
      session_(client_.get_executor()),
      timer_(client_.get_executor()),
      place_(std::move(place)),
      admit_(std::move(admit)) {}

void TlsRelay::start() {
  error_code ignored;
  auto& socket = client_.next_layer();
  address_ = socket.remote_endpoint(ignored).address().to_string();
  socket.set_option(tcp::no_delay(true), ignored);
  socket.non_blocking(true, ignored);  // to look at the first byte must not wait
  limit(kLongestHandshake);
  socket.async_wait(tcp::socket::wait_read, [self = shared_from_this()](error_code error) {
    if (error) return self->cut();
    self->look_at_first_byte();
  });
}

void TlsRelay::look_at_first_byte() {
  constexpr std::uint8_t kHandshakeRecord = 22;
  std::uint8_t first = 0;
  error_code error;
  const auto size =
      client_.next_layer().receive(asio::buffer(&first, 1), tcp::socket::message_peek, error);
  if (error || size == 0) return cut();
  if (first != kHandshakeRecord) return tell_plain_client();
  client_.async_handshake(asio::ssl::stream_base::server,
                          [self = shared_from_this()](error_code failed) {
                            if (failed) return self->cut();
                            self->admit();
                          });
}

void TlsRelay::tell_plain_client() {
  asio::async_write(client_.next_layer(), asio::buffer(plain_answer()),
                    [self = shared_from_this()](error_code error, std::size_t) {
                      if (error) return self->cut();
                      self->read_to_end();
                    });
}

void TlsRelay::admit() {
  tcp::socket for_session(client_.get_executor());
  if (!make_pair(for_session)) return cut();
  no_limit();
  place_.reset();
  read_client();
  read_session();
  admit_(std::move(for_session), address_);
}

/// Returns false if the process has no more descriptors. Asio's sockets for TCP read and write any
/// stream of bytes; only the address that they tell is none.
bool TlsRelay::make_pair(tcp::socket& for_session) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
  error_code first, second, ignored;
  session_.assign(tcp::v4(), ends[0], first);
  if (first) ::close(ends[0]);
  for_session.assign(tcp::v4(), ends[1], second);
  if (second) ::close(ends[1]);
  if (first || second) return false;
  for_session.set_option(asio::socket_base::send_buffer_size(kPairBytes), ignored);
  session_.set_option(asio::socket_base::send_buffer_size(kPairBytes), ignored);
  return true;
}

void TlsRelay::read_client() {
  reads_client_ = true;
  client_.async_read_some(
      asio::buffer(from_client_), [self = shared_from_this()](error_code error, std::size_t size) {
        self->reads_client_ = false;
        if (self->closes_) return self->say_goodbye();
        if (error) {  // the session sees the end, and closes its socket when it is done
          error_code ignored;
          self->session_.shutdown(tcp::socket::shutdown_send, ignored);
          return;
        }
        asio::async_write(self->session_, asio::buffer(self->from_client_, size),
                          [self](error_code closed, std::size_t) {
                            if (!closed && !self->closes_) self->read_client();
                          });
      });
}

void TlsRelay::read_session() {
  session_.async_read_some(
      asio::buffer(from_session_), [self = shared_from_this()](error_code error, std::size_t size) {
        if (error) return self->close();
        self->limit(kLongestWrite);
        asio::async_write(self->client_, asio::buffer(self->from_session_, size),
                          [self](error_code lost, std::size_t) {
                            if (lost) return self->cut();
                            self->no_limit();
                            self->read_session();
                          });
      });
}

/// The session has closed its socket, and all that it had sent has gone to the client.
void TlsRelay::close() {
  closes_ = true;
  limit(kLongestGoodbye);
  if (!reads_client_) return say_goodbye();
  error_code ignored;
  client_.next_layer().cancel(ignored);  // reading ends, and says goodbye
}

void TlsRelay::say_goodbye() {
  client_.async_shutdown([self = shared_from_this()](error_code) { self->read_to_end(); });
}

/// Reads what a client still sends: to close now would take the last bytes away from it.
void TlsRelay::read_to_end() {
  error_code ignored;
  client_.next_layer().shutdown(tcp::socket::shutdown_send, ignored);
  client_.next_layer().async_read_some(asio::buffer(from_client_),
                                       [self = shared_from_this()](error_code error, std::size_t) {
                                         if (error) return self->cut();
                                         self->read_to_end();
                                       });
}

void TlsRelay::cut() {
  no_limit();
  error_code ignored;
  client_.next_layer().close(ignored);
  session_.close(ignored);
}

void TlsRelay::limit(std::chrono::seconds most) {
  timer_.expires_after(most);
  timer_.async_wait([self = shared_from_this(), number = ++limits_](error_code error) {
    if (!error && number == self->limits_) self->cut();
  });
}

void TlsRelay::no_limit() {
  ++limits_;
  timer_.cancel();
}

}  // namespace galilean::monitor
