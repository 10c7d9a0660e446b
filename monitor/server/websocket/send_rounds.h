// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace galilean::monitor {

/// Sends what waits for many clients in rounds: at once where the last round is a while ago, else
/// kPause after it. What a busy team says within one pause goes to each client in one system call,
/// which costs more than what it carries.
class SendRounds {
 public:
  static constexpr auto kPause = std::chrono::milliseconds(1);

  class Sender {
   public:
    virtual ~Sender() = default;
    /// Throws nothing: there are others in the round.
    virtual void send_waiting() = 0;

   private:
    friend class SendRounds;
    bool is_in_round_ = false;
  };

  explicit SendRounds(boost::asio::io_context& io) : timer_(io) {}

  /// `sender` takes part in the next round, which keeps it until then. Whoever it sends for may be
  /// gone by that time.
  void add(std::shared_ptr<Sender> sender) {
    if (std::exchange(sender->is_in_round_, true)) return;
    next_.push_back(std::move(sender));
    if (next_.size() == 1) begin_later();
  }

 private:
  void begin_later() {
    timer_.expires_at(last_ + kPause);
    timer_.async_wait([this](boost::system::error_code error) {
      if (!error) send_all();
    });
  }
  void send_all() {
    last_ = std::chrono::steady_clock::now();
    std::swap(next_, now_);
    for (const auto& sender : now_) {
      sender->is_in_round_ = false;
      sender->send_waiting();
    }
    now_.clear();
  }

  boost::asio::steady_timer timer_;
  std::chrono::steady_clock::time_point last_{};
  std::vector<std::shared_ptr<Sender>> next_, now_;
};

}  // namespace galilean::monitor
