// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "monitor/background/guarded.h"
#include "monitor/server/websocket/outbox.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// A TCP socket below Beast's WebSocket stream that coalesces frames: it writes up to 64 frames of
/// an Outbox at once, because a system call costs more than a small frame. Beast reads through it
/// and writes its handshake, its messages and its control frames into it. Frames go out between
/// Beast's writes, each of which is a whole message. A write of Beast is done when its bytes have
/// left, so that a client that does not read holds its session up. For use on the io_context's one
/// thread.
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
  /// Closes the socket soon, but not from inside this call.
  void close_later() {
    boost::asio::post(get_executor(), [state = state_] { state->close(); });
  }

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
          // A handler can only be moved, and a std::function is copied.
          auto kept = std::make_shared<decltype(completion)>(std::move(completion));
          state_->control_written.emplace_back(
              [kept, size](error_code error) { (*kept)(error, error ? 0 : size); });
          if (state_->failed) return state_->fail_waiting();
          state_->send_waiting();
        },
        handler);
  }

 private:
  static constexpr std::size_t kFramesAtOnce = 64;
  using Written = std::vector<std::function<void(error_code)>>;

  struct State final : SendRounds::Sender, std::enable_shared_from_this<State> {
    tcp::socket socket;
    SendRounds& rounds;
    std::weak_ptr<Outbox> outbox = {};
    std::vector<std::uint8_t> control = {};  ///< what Beast wrote and waits
    Written control_written = {};            ///< whom to tell when `control` has left
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
      boost::asio::async_write(
          socket, gathered(),
          [self = this->shared_from_this(), told = std::exchange(control_written, {})](
              error_code error, std::size_t) {
            self->go_on_after(error);
            for (const auto& tell : told) tell(error);
          });
    }
    void go_on_after(error_code error) {
      const bool more_waits = frames_in_flight.size() == kFramesAtOnce || !control.empty();
      writing = false;
      if (error) failed = error;
      if (failed) return fail_waiting();
      if (more_waits) return send_waiting();
      if (const auto source = outbox.lock(); source && !source->empty()) join_round();
    }
    /// Tells whoever waits for a write that it failed, but not from inside its own call.
    void fail_waiting() {
      for (auto& tell : std::exchange(control_written, {}))
        boost::asio::post(socket.get_executor(),
                          [tell = std::move(tell), error = failed] { tell(error); });
    }
    /// A pending read fails because of this, which tells its owner that the connection is closed.
    void close() {
      failed = boost::asio::error::connection_aborted;
      outbox.reset();
      error_code ignored;
      socket.close(ignored);
      if (!writing) fail_waiting();
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
