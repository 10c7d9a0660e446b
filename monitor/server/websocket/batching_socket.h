// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <cstdint>
#include <memory>
#include <vector>

#include "monitor/background/guarded.h"
#include "monitor/server/websocket/outbox.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// A TCP socket below Beast's WebSocket stream that coalesces frames: it writes up to 64 frames of
/// an Outbox at once, because a system call costs more than a small frame. Beast reads through it
/// and writes its handshake and control frames into it. Frames go out between Beast's writes, each
/// of which is a whole message. For use on the io_context's one thread.
class BatchingSocket {
 public:
  using tcp = boost::asio::ip::tcp;
  using executor_type = tcp::socket::executor_type;
  using next_layer_type = tcp::socket;
  using error_code = boost::system::error_code;

  BatchingSocket(tcp::socket socket, SendRounds& rounds)
      : state_(std::make_shared<State>(std::move(socket), rounds)) {}

  [[nodiscard]] executor_type get_executor() noexcept { return state_->socket.get_executor(); }
  [[nodiscard]] next_layer_type& next_layer() noexcept { return state_->socket; }
  [[nodiscard]] const next_layer_type& next_layer() const noexcept { return state_->socket; }

  /// Sends the frames of `outbox` from now on, for as long as the outbox lives. An empty pointer
  /// stops that.
  void send_from(std::weak_ptr<Outbox> outbox) { state_->outbox = std::move(outbox); }
  /// Sends the waiting frames with the next round.
  void flush() { state_->join_round(); }
  /// Closes the socket. A write in flight would otherwise keep the connection open after its
  /// session is gone.
  void close() { state_->close(); }

  template <class Buffers, class Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    return state_->socket.async_read_some(buffers, std::forward<Handler>(handler));
  }

  template <class Buffers, class Handler>
  auto async_write_some(const Buffers& buffers, Handler&& handler) {
    return boost::asio::async_initiate<Handler, void(error_code, std::size_t)>(
        [this, &buffers](auto completion) {
          const auto size = boost::asio::buffer_size(buffers);
          const auto start = state_->control.size();
          state_->control.resize(start + size);
          boost::asio::buffer_copy(boost::asio::buffer(state_->control.data() + start, size),
                                   buffers);
          state_->send_waiting();
          boost::asio::post(get_executor(), boost::beast::bind_front_handler(std::move(completion),
                                                                             state_->failed, size));
        },
        handler);
  }

 private:
  static constexpr std::size_t kFramesAtOnce = 64;

  struct State final : SendRounds::Sender, std::enable_shared_from_this<State> {
    tcp::socket socket;
    SendRounds& rounds;
    std::weak_ptr<Outbox> outbox = {};
    std::vector<std::uint8_t> control = {};
    std::vector<std::uint8_t> control_in_flight = {};
    std::vector<Frame> frames_in_flight = {};
    bool writing = false;
    error_code failed = {};

    State(tcp::socket connected, SendRounds& shared)
        : socket(std::move(connected)), rounds(shared) {}

    void join_round() {
      if (!writing && !failed) rounds.add(this->shared_from_this());
    }
    void send_waiting() override {
      if (writing || failed) return;
      if (!guarded("sending to a client", [this] { write_waiting(); })) close();
    }
    void write_waiting() {
      const auto source = outbox.lock();
      control_in_flight = std::exchange(control, {});
      frames_in_flight = source ? source->take(kFramesAtOnce) : std::vector<Frame>();
      if (control_in_flight.empty() && frames_in_flight.empty()) return;
      writing = true;
      boost::asio::async_write(socket, gathered(),
                               [self = this->shared_from_this()](error_code error, std::size_t) {
                                 self->written(error);
                               });
    }
    void written(error_code error) {
      const bool more_waits = frames_in_flight.size() == kFramesAtOnce || !control.empty();
      writing = false;
      failed = error;
      if (more_waits) return send_waiting();
      if (const auto source = outbox.lock(); source && !source->empty()) join_round();
    }
    /// A pending read fails because of this, which tells its owner that the connection is closed.
    void close() {
      failed = boost::asio::error::connection_aborted;
      outbox.reset();
      error_code ignored;
      socket.close(ignored);
    }

    [[nodiscard]] std::vector<boost::asio::const_buffer> gathered() const {
      std::vector<boost::asio::const_buffer> buffers;
      buffers.reserve(1 + 2 * frames_in_flight.size());
      if (!control_in_flight.empty()) buffers.push_back(boost::asio::buffer(control_in_flight));
      for (const Frame& frame : frames_in_flight) {
        buffers.emplace_back(frame.head.data(), frame.head_size);
        if (frame.payload) buffers.emplace_back(frame.payload->data(), frame.payload->size());
      }
      return buffers;
    }
  };

  std::shared_ptr<State> state_;  ///< shared with writes in flight and with the next round
};

// Beast finds these two by their argument's type, and ends the connection with them.
inline void teardown(boost::beast::role_type role, BatchingSocket& socket,
                     boost::system::error_code& error) {
  boost::beast::websocket::teardown(role, socket.next_layer(), error);
}
template <class Handler>
void async_teardown(boost::beast::role_type role, BatchingSocket& socket, Handler&& handler) {
  boost::beast::websocket::async_teardown(role, socket.next_layer(),
                                          std::forward<Handler>(handler));
}

}  // namespace galilean::monitor
