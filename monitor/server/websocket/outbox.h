// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "monitor/server/websocket/frame.h"

namespace galilean::monitor {

/// What waits to be sent to one client. What must arrive (events, answers) stands in one queue in
/// order, which is bounded: a client that lets it fill up is too slow to be served. Of what is
/// superseded by its successor (states, streams) each subscription keeps its newest few in a lane
/// of its own, so that a slow client gets less often what a quick one gets, and never falls behind.
class Outbox {
 public:
  static constexpr std::size_t kMostQueuedBytes = 16 << 20;

  /// False if the client is too slow.
  [[nodiscard]] bool push(Frame frame);
  /// Replaces the oldest frame of `lane` if that holds `depth` already.
  void offer(std::uint32_t lane, Frame frame, std::size_t depth);
  /// Forgets what waits in `lane`.
  void close_lane(std::uint32_t lane);
  void clear();

  /// Moves at most `most` frames out, the queue first, then the lanes in turn.
  [[nodiscard]] std::vector<Frame> take(std::size_t most);
  [[nodiscard]] bool empty() const noexcept { return queue_.empty() && turns_.empty(); }
  [[nodiscard]] std::uint64_t superseded() const noexcept { return superseded_; }

 private:
  std::deque<Frame> queue_;
  std::size_t queued_bytes_ = 0;
  std::unordered_map<std::uint32_t, std::deque<Frame>> lanes_;
  std::deque<std::uint32_t> turns_;  ///< lanes with something in them, each once
  std::uint64_t superseded_ = 0;
};

}  // namespace galilean::monitor
