// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace galilean::robot {

/// Lines of the log on their way to those who listen from afar. Any thread but the control loop.
class LogQueue {
 public:
  struct Line {
    std::int64_t time_ns = 0;  ///< since the Unix epoch
    std::uint8_t level = 0;    ///< as rcl_interfaces/Log has it: 10, 20 … 50
    std::string text;
  };

  /// The oldest gives way where nobody takes them.
  void push(Line line);
  [[nodiscard]] std::vector<Line> take();

 private:
  static constexpr std::size_t kMost = 64;

  std::mutex mutex_;
  std::deque<Line> lines_;
};

/// From now on spdlog's default logger writes into `queue` too, until the returned object goes.
class LogForwarding {
 public:
  explicit LogForwarding(LogQueue& queue);
  ~LogForwarding();
  LogForwarding(const LogForwarding&) = delete;
  LogForwarding& operator=(const LogForwarding&) = delete;

 private:
  struct Sink;
  std::shared_ptr<Sink> sink_;
};

}  // namespace galilean::robot
