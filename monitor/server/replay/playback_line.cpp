// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/playback_line.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {

bool PlaybackLine::order(PlaybackOrder order) {
  const std::lock_guard lock(mutex_);
  if (orders_.size() >= kMostOrders) return false;
  orders_.push_back(std::move(order));
  changed_.notify_one();
  return true;
}

void PlaybackLine::taken(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  waiting_bytes_ -= std::min(bytes, waiting_bytes_);
  changed_.notify_one();
}

void PlaybackLine::leave() {
  const std::lock_guard lock(mutex_);
  left_ = true;
  changed_.notify_one();
}

bool PlaybackLine::wait(Duration most) {
  std::unique_lock lock(mutex_);
  const bool was_full = waiting_bytes_ >= kMostWaitingBytes;
  const auto is_something = [&] {
    const bool has_room = waiting_bytes_ < kMostWaitingBytes;
    return left_ || (has_room && (was_full || !orders_.empty()));
  };
  changed_.wait_for(lock, most, is_something);
  return !left_;
}

std::vector<PlaybackOrder> PlaybackLine::take_orders() {
  const std::lock_guard lock(mutex_);
  return std::exchange(orders_, {});
}

bool PlaybackLine::has_room() {
  const std::lock_guard lock(mutex_);
  return waiting_bytes_ < kMostWaitingBytes;
}

void PlaybackLine::send(ForViewer what) {
  std::size_t bytes = 0;
  for (const auto& frame : what.frames) bytes += frame.size();
  {
    const std::lock_guard lock(mutex_);
    waiting_bytes_ += bytes;
  }
  deliver_(std::move(what));
}

}  // namespace galilean::monitor
