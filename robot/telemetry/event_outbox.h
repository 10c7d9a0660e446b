// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>

namespace galilean::robot {

/// Sends events in their order. DDS does not take one in time while a reader that is cut off has
/// not confirmed many others, until that reader is forgotten. Such an event waits here, so that it
/// gets its place in the writer's history, from which that reader hears it later. For use by one
/// thread.
template <class M>
class EventOutbox {
 public:
  static constexpr std::size_t kMost = 1024;  ///< beyond, the oldest is dropped
  /// Returns whether DDS took the event. It may block for some milliseconds.
  using Write = std::function<bool(const M&)>;

  explicit EventOutbox(Write write) : write_(std::move(write)) {}

  /// Sends an event, unless others wait: then it waits behind them. So a round is held up by one
  /// event that DDS does not take, and not by each.
  void send(M event) {
    if (waiting_.empty() && write_(event)) return;
    waiting_.push_back(std::move(event));
    if (waiting_.size() <= kMost) return;
    waiting_.pop_front();
    ++dropped_;
  }
  /// Sends the events that wait, until DDS does not take one. Call it in each round.
  void send_waiting() {
    while (!waiting_.empty() && write_(waiting_.front())) waiting_.pop_front();
  }

  [[nodiscard]] std::size_t waiting() const noexcept { return waiting_.size(); }
  /// Returns how many events were dropped, of all time.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  Write write_;
  std::deque<M> waiting_;
  std::uint64_t dropped_ = 0;
};

}  // namespace galilean::robot
