// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/websocket_crowd.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace galilean::bench {
namespace {

constexpr std::size_t kReadAtOnce = 256 << 10;
constexpr std::size_t kMaskBytes = 4;

int connect_to(std::uint16_t port) {
  const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
  if (descriptor < 0)
    throw std::runtime_error(std::string("a client has no socket: ") + std::strerror(errno) +
                             "; see 'ulimit -Hn'");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error("nobody listens on port " + std::to_string(port));
  const int on = 1;
  setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return descriptor;
}

/// Each client takes a file descriptor, and the usual limit is a thousand.
void raise_descriptor_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  (void)setrlimit(RLIMIT_NOFILE, &limit);
}

void send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) throw std::runtime_error("the server closed a connection");
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

/// Returns how many bytes a frame's header has, as far as `head` shows: 2, 4 or 10.
std::size_t head_bytes(std::span<const std::uint8_t> head) {
  if (head.size() < 2) return 2;
  const auto length = head[1] & 127;
  return length == 126 ? 4 : length == 127 ? 10 : 2;
}

std::uint64_t payload_size(std::span<const std::uint8_t> head) {
  if (head.size() == 2) return head[1] & 127;
  std::uint64_t size = 0;
  for (const auto byte : head.subspan(2)) size = size << 8 | byte;
  return size;
}

}  // namespace

WebSocketCrowd::WebSocketCrowd(std::uint16_t port, const std::string& target,
                               const std::string& subprotocol, std::size_t clients)
    : epoll_(epoll_create1(0)), clients_(clients), buffer_(kReadAtOnce) {
  raise_descriptor_limit();
  for (std::size_t i = 0; i < clients; ++i) {
    clients_[i].socket = connect_to(port);
    handshake(clients_[i].socket, port, target, subprotocol);
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = i;
    epoll_ctl(epoll_, EPOLL_CTL_ADD, clients_[i].socket, &event);
  }
}

WebSocketCrowd::~WebSocketCrowd() {
  for (const auto& client : clients_) close(client.socket);
  close(epoll_);
}

void WebSocketCrowd::handshake(int socket, std::uint16_t port, const std::string& target,
                               const std::string& subprotocol) {
  send_all(socket,
           "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
               "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
               "Sec-WebSocket-Version: 13\r\n" +
               (subprotocol.empty() ? "" : "Sec-WebSocket-Protocol: " + subprotocol + "\r\n") +
               "\r\n");
  std::string answer;
  for (char byte; !answer.ends_with("\r\n\r\n"); answer += byte)  // reads nothing behind the answer
    if (recv(socket, &byte, 1, 0) != 1) throw std::runtime_error("the server closed a connection");
  if (answer.find(" 101 ") == answer.npos) throw std::runtime_error("no WebSocket: " + answer);
}

void WebSocketCrowd::send(std::size_t client, std::uint8_t first_byte, std::string_view payload) {
  std::string frame{static_cast<char>(first_byte)};
  constexpr std::size_t kMasked = 128, kLongest = 0xffff;
  if (payload.size() > kLongest) throw std::runtime_error("no client sends so much at once");
  if (payload.size() < 126) {
    frame += static_cast<char>(kMasked | payload.size());
  } else {
    frame += static_cast<char>(kMasked | 126);
    frame += static_cast<char>(payload.size() >> 8);
    frame += static_cast<char>(payload.size() & 255);
  }
  frame.append(kMaskBytes, '\0');  // a mask of zeros leaves the payload as it is
  send_all(clients_[client].socket, frame.append(payload));
}

void WebSocketCrowd::stall(std::size_t client) {
  epoll_ctl(epoll_, EPOLL_CTL_DEL, clients_[client].socket, nullptr);
}

void WebSocketCrowd::read(std::chrono::milliseconds patience, const OnFrame& on_frame) {
  std::array<epoll_event, 128> ready;
  const int count = epoll_wait(epoll_, ready.data(), static_cast<int>(ready.size()),
                               static_cast<int>(patience.count()));
  for (int i = 0; i < count; ++i) {
    const auto client = static_cast<std::size_t>(ready[static_cast<std::size_t>(i)].data.u64);
    const auto got = recv(clients_[client].socket, buffer_.data(), buffer_.size(), MSG_DONTWAIT);
    if (got == 0) throw std::runtime_error("the server closed a connection");
    if (got > 0) parse(client, std::span(buffer_).first(static_cast<std::size_t>(got)), on_frame);
  }
}

/// Returns how many of `bytes` belong to the header and to the part of the payload that is kept.
std::size_t WebSocketCrowd::take_head(Client& client, std::span<const std::uint8_t> bytes) const {
  std::size_t taken = 0;
  const auto fill = [&](std::size_t to) {
    while (client.head_size < to && taken < bytes.size())
      client.head[client.head_size++] = bytes[taken++];
    return client.head_size >= to;
  };
  if (!fill(2)) return taken;
  const auto head = head_bytes(client.head);
  if (!fill(head)) return taken;
  const auto size = payload_size(std::span(client.head).first(head));
  (void)fill(head + std::min<std::uint64_t>(size, kKept));
  return taken;
}

void WebSocketCrowd::parse(std::size_t number, std::span<const std::uint8_t> bytes,
                           const OnFrame& on_frame) {
  Client& client = clients_[number];
  while (!bytes.empty()) {
    if (client.skip > 0) {
      const auto skipped = std::min<std::uint64_t>(client.skip, bytes.size());
      client.skip -= skipped;
      bytes = bytes.subspan(skipped);
      continue;
    }
    bytes = bytes.subspan(take_head(client, bytes));
    if (client.head_size < 2) return;
    const auto head = head_bytes(client.head);
    if (client.head_size < head) return;
    const auto size = payload_size(std::span(client.head).first(head));
    const auto kept = std::min<std::uint64_t>(size, kKept);
    if (client.head_size < head + kept) return;
    client.skip = size - kept;
    client.head_size = 0;
    on_frame({number, static_cast<std::uint8_t>(client.head[0] & 15), size,
              std::span(client.head).subspan(head, kept)});
  }
}

}  // namespace galilean::bench
