// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

namespace galilean::monitor {

/// Does the work that clients ask for and that may wait: one after another on the io_context's
/// thread, in the order in which it came. After each the thread is free for other work for as long
/// as that one took. However many clients ask, an operator's command, which takes no turn,
/// therefore waits for one of them at most each time that it needs the thread. A client has one
/// work at most that waits, so the number of connections bounds them. Own it by a shared_ptr.
class Turns : public std::enable_shared_from_this<Turns> {
 public:
  explicit Turns(boost::asio::io_context& io) : timer_(io) {}

  /// Does `work` when its turn comes, which is never inside of this call. `work` must not throw.
  void take(std::function<void()> work) {
    if (is_over_) return;
    waiting_.push_back(std::move(work));
    if (!std::exchange(is_waiting_, true)) wait();
  }
  /// Drops what waits, and takes no more.
  void end() {
    is_over_ = true;
    const auto dropped = std::exchange(waiting_, {});  // which may own what owns this
    timer_.cancel();
  }

 private:
  using Clock = std::chrono::steady_clock;

  void wait() {
    timer_.expires_at(free_);
    timer_.async_wait([weak = weak_from_this()](boost::system::error_code error) {
      const auto self = weak.lock();
      if (self && !error) self->do_one();
    });
  }
  void do_one() {
    if (waiting_.empty()) return;  // it was ended meanwhile
    const auto work = std::move(waiting_.front());
    waiting_.pop_front();
    const auto began = Clock::now();
    work();
    const auto ended = Clock::now();
    free_ = ended + (ended - began);
    is_waiting_ = !waiting_.empty();
    if (is_waiting_) wait();
  }

  boost::asio::steady_timer timer_;
  Clock::time_point free_{};  ///< when the next may begin
  std::deque<std::function<void()>> waiting_;
  bool is_waiting_ = false;  ///< for the timer, or a work is being done
  bool is_over_ = false;
};

}  // namespace galilean::monitor
