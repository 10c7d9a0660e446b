// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "core/clock.h"

namespace galilean::monitor {

/// Does the work that clients ask for and that may wait, in the order in which it came, on the
/// io_context's thread. It takes half of the thread's time at most: after what took longer than
/// kBurst, the thread is free for other work for as long. However many clients ask, an operator's
/// command, which takes no turn, therefore waits for about one of their works each time that it
/// needs the thread. A client has one work at most that waits, so the number of connections bounds
/// them. Own it by a shared_ptr.
class Turns : public std::enable_shared_from_this<Turns> {
 public:
  /// So much work is done without a pause after a time without any.
  static constexpr Duration kBurst = std::chrono::milliseconds(1);

  /// Requires: `io` and `clock` outlive this.
  Turns(boost::asio::io_context& io, const Clock& clock) : timer_(io), clock_(clock) {}

  /// Does `work` now, or when its turn comes. `work` must not throw.
  void take(std::function<void()> work) {
    if (is_over_) return;
    if (waiting_.empty() && is_free()) return do_now(work);
    waiting_.push_back(std::move(work));
    wait();
  }
  /// Drops what waits, and takes no more.
  void end() {
    is_over_ = true;
    const auto dropped = std::exchange(waiting_, {});  // which may own what owns this
    timer_.cancel();
  }

 private:
  [[nodiscard]] bool is_free() const { return clock_.now() >= free_; }

  void do_now(const std::function<void()>& work) {
    const Time began = clock_.now();
    work();
    const Duration took = clock_.now() - began;
    free_ = std::max(free_, began - kBurst) + 2 * took;
  }
  void wait() {
    if (std::exchange(is_waiting_, true)) return;
    timer_.expires_after(free_ - clock_.now());
    timer_.async_wait([weak = weak_from_this()](boost::system::error_code error) {
      const auto self = weak.lock();
      if (self && !error) self->go_on();
    });
  }
  void go_on() {
    is_waiting_ = false;
    while (!waiting_.empty() && is_free()) {
      const auto work = std::move(waiting_.front());
      waiting_.pop_front();
      do_now(work);
    }
    if (!waiting_.empty()) wait();
  }

  boost::asio::steady_timer timer_;
  const Clock& clock_;
  Time free_{};  ///< when the next may begin
  std::deque<std::function<void()>> waiting_;
  bool is_waiting_ = false;  ///< for the timer
  bool is_over_ = false;
};

}  // namespace galilean::monitor
