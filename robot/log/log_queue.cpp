// SPDX-License-Identifier: BSD-3-Clause
#include "robot/log/log_queue.h"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace galilean::robot {

void LogQueue::push(Line line) {
  const std::lock_guard lock(mutex_);
  if (lines_.size() == kMost) lines_.pop_front();
  lines_.push_back(std::move(line));
}

std::vector<LogQueue::Line> LogQueue::take() {
  const std::lock_guard lock(mutex_);
  std::vector<Line> lines(std::make_move_iterator(lines_.begin()),
                          std::make_move_iterator(lines_.end()));
  lines_.clear();
  return lines;
}

struct LogForwarding::Sink final : spdlog::sinks::base_sink<std::mutex> {
  explicit Sink(LogQueue& to) : queue(to) {}

  void sink_it_(const spdlog::details::log_msg& message) override {
    using std::chrono::duration_cast, std::chrono::nanoseconds;
    queue.push({duration_cast<nanoseconds>(message.time.time_since_epoch()).count(),
                ros_level(message.level),
                std::string(message.payload.data(), message.payload.size())});
  }
  void flush_() override {}

  static std::uint8_t ros_level(spdlog::level::level_enum level) {
    constexpr int kDebug = 10;
    return static_cast<std::uint8_t>(kDebug * std::clamp<int>(level, 1, 5));
  }

  LogQueue& queue;
};

LogForwarding::LogForwarding(LogQueue& queue) : sink_(std::make_shared<Sink>(queue)) {
  spdlog::default_logger()->sinks().push_back(sink_);
}

LogForwarding::~LogForwarding() {
  auto& sinks = spdlog::default_logger()->sinks();
  std::erase(sinks, sink_);
}

}  // namespace galilean::robot
