// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace galilean::robot {

/// Lines of the log that wait to be published. Any thread but the control loop may call it.
class LogQueue {
 public:
  struct Line {
    std::int64_t time_ns = 0;  ///< since the Unix epoch
    std::uint8_t level = 0;    ///< as in rcl_interfaces/Log: 10, 20 … 50
    std::string text;
  };

  /// Appends a line. If nobody takes the lines, the oldest is dropped.
  void push(Line line);
  [[nodiscard]] std::vector<Line> take();

 private:
  static constexpr std::size_t kMost = 64;

  std::mutex mutex_;
  std::deque<Line> lines_;
};

/// Makes spdlog's default logger write into `queue` too, until this object is destroyed.
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
