// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <poll.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace galilean::monitor {

/// Answers SIGINT and SIGTERM on a thread of its own, so that they are answered whatever the other
/// threads do. It asks the process to end, and ends it at once if it is still there after a while:
/// a part that hangs must not keep it from that. What was acknowledged is on the disk by then.
class EndWatch {
 public:
  /// A process in order takes a second.
  static constexpr auto kPatience = std::chrono::seconds(8);

  /// `end` is called once, on the thread of this, after the first of the signals. It must not wait.
  /// Requires: what `end` uses lives until `forget` or the destructor.
  explicit EndWatch(std::function<void()> end, std::chrono::milliseconds patience = kPatience)
      : end_(std::move(end)), patience_(patience) {
    signals_.async_wait([this](boost::system::error_code error, int) {
      if (!error) ask();
    });
    thread_ = std::thread([this] { io_.run(); });
  }
  ~EndWatch() {
    io_.stop();
    thread_.join();
  }
  EndWatch(const EndWatch&) = delete;
  EndWatch& operator=(const EndWatch&) = delete;

  /// Has `end` called no more. The process ends already; it is still ended at once if that takes
  /// too long after a signal.
  void forget() {
    const std::lock_guard lock(mutex_);
    end_ = nullptr;
  }

 private:
  void ask() {
    {
      const std::lock_guard lock(mutex_);
      if (end_) std::exchange(end_, nullptr)();
    }
    timer_.expires_after(patience_);
    timer_.async_wait([](boost::system::error_code error) {
      if (error) return;
      tell("galilean-monitor: it was told to end and a part of it hangs, so it ends at once.\n");
      std::_Exit(EXIT_FAILURE);
    });
  }
  /// Who reads stderr may be what hangs.
  static void tell(std::string_view sentence) {
    pollfd out{STDERR_FILENO, POLLOUT, 0};
    if (poll(&out, 1, 0) != 1) return;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
  }

  std::mutex mutex_;
  std::function<void()> end_;
  const std::chrono::milliseconds patience_;
  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_{io_, SIGINT, SIGTERM};
  boost::asio::steady_timer timer_{io_};
  std::thread thread_;
};

}  // namespace galilean::monitor
