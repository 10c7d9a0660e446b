// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace galilean::monitor {

/// Coalesces sending to many clients into rounds. A round begins at once if the last one was at
/// least kPause ago, else kPause after it. All messages of one pause thus go to a client in one
/// write, because a system call costs more than the messages. Between each kAtOnce senders of a
/// round others have their turn, so that a command does not wait until a thousand clients were sent
/// to. For use on the io_context's one thread.
class SendRounds {
 public:
  static constexpr auto kPause = std::chrono::milliseconds(1);
  static constexpr std::size_t kAtOnce = 32;

  class Sender {
   public:
    virtual ~Sender() = default;
    /// Sends what waits. Must not throw, because that would keep the rest of the round from
    /// sending.
    virtual void send_waiting() = 0;

   private:
    friend class SendRounds;
    bool is_in_round_ = false;
  };

  explicit SendRounds(boost::asio::io_context& io) : timer_(io) {}

  /// Adds `sender` to the next round, if it is not in it yet. The round keeps the sender alive, so
  /// the session that it sends for may be gone by then.
  void add(std::shared_ptr<Sender> sender) {
    if (std::exchange(sender->is_in_round_, true)) return;
    next_.push_back(std::move(sender));
    if (next_.size() == 1 && now_.empty()) begin_later();
  }

 private:
  void begin_later() {
    timer_.expires_at(last_ + kPause);
    timer_.async_wait([this](boost::system::error_code error) {
      if (error) return;
      last_ = std::chrono::steady_clock::now();
      std::swap(next_, now_);
      send_some();
    });
  }
  void send_some() {
    for (std::size_t count = 0; count < kAtOnce && sent_ < now_.size(); ++count, ++sent_) {
      const auto& sender = now_[sent_];
      sender->is_in_round_ = false;
      sender->send_waiting();
    }
    if (sent_ < now_.size()) {
      timer_.expires_at(std::chrono::steady_clock::now());
      timer_.async_wait([this](boost::system::error_code error) {
        if (!error) send_some();
      });
      return;
    }
    now_.clear();
    sent_ = 0;
    if (!next_.empty()) begin_later();
  }

  boost::asio::steady_timer timer_;
  std::chrono::steady_clock::time_point last_{};
  std::vector<std::shared_ptr<Sender>> next_, now_;
  std::size_t sent_ = 0;  ///< of those in now_
};

}  // namespace galilean::monitor
