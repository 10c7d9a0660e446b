// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/websocket/outbox.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {

bool Outbox::push(Frame frame) {
  queued_bytes_ += frame.kept_size();
  queue_.push_back(std::move(frame));
  return queued_bytes_ <= kMostQueuedBytes;
}

void Outbox::offer(std::uint32_t lane, Frame frame, std::size_t depth) {
  auto& [waiting, turn] = lanes_[lane];
  if (waiting.empty()) turn = turns_.insert(turns_.end(), lane);
  if (waiting.size() >= depth) {
    waiting.pop_front();
    ++superseded_;
  }
  waiting.push_back(std::move(frame));
}

void Outbox::close_lane(std::uint32_t lane) {
  const auto found = lanes_.find(lane);
  if (found == lanes_.end()) return;
  if (!found->second.waiting.empty()) turns_.erase(found->second.turn);
  lanes_.erase(found);
}

void Outbox::clear() {
  queue_.clear();
  if (const auto bytes = std::exchange(queued_bytes_, 0); tell_taken_ && bytes > 0)
    tell_taken_(bytes);
  lanes_.clear();
  turns_.clear();
}

std::vector<Frame> Outbox::take(std::size_t most) {
  std::vector<Frame> taken;
  const auto queued_before = queued_bytes_;
  for (; taken.size() < most && !queue_.empty(); queue_.pop_front()) {
    queued_bytes_ -= queue_.front().kept_size();
    taken.push_back(std::move(queue_.front()));
  }
  if (tell_taken_ && queued_bytes_ < queued_before) tell_taken_(queued_before - queued_bytes_);
  while (taken.size() < most && !turns_.empty()) {
    auto& [waiting, turn] = lanes_[turns_.front()];
    taken.push_back(std::move(waiting.front()));
    waiting.pop_front();
    if (waiting.empty())
      turns_.erase(turn);
    else
      turns_.splice(turns_.end(), turns_, turn);
  }
  return taken;
}

}  // namespace galilean::monitor
