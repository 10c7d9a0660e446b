// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <unordered_map>
#include <vector>

#include "monitor/server/websocket/frame.h"

namespace galilean::monitor {

/// The frames that wait to be sent to one client. Events and answers must all arrive, so they wait
/// in one bounded queue, in order; a client that lets it fill up is too slow to be served. A newer
/// state or stream message supersedes an older one, so each subscription keeps only its newest few
/// in a lane of its own. A slow client thus gets these messages less often, but never late.
class Outbox {
 public:
  static constexpr std::size_t kMostQueuedBytes = 16 << 20;

  /// Adds a frame to the queue. Returns false if more than kMostQueuedBytes wait there now, because
  /// the client is too slow.
  [[nodiscard]] bool push(Frame frame);
  /// Adds a frame to `lane`. It replaces the oldest frame there if the lane holds `depth` frames.
  /// Requires: `depth` > 0.
  void offer(std::uint32_t lane, Frame frame, std::size_t depth);
  /// Drops the frames that wait in `lane`.
  void close_lane(std::uint32_t lane);
  void clear();

  /// Removes and returns at most `most` frames: first those of the queue, then one of each lane in
  /// turn.
  [[nodiscard]] std::vector<Frame> take(std::size_t most);
  /// Calls `tell` with the size of the frames of the queue [bytes] whenever some of them are taken
  /// or dropped.
  void on_taken(std::function<void(std::size_t bytes)> tell) { tell_taken_ = std::move(tell); }
  /// Returns what the frames of the queue take to keep.
  [[nodiscard]] std::size_t queued_bytes() const noexcept { return queued_bytes_; }
  [[nodiscard]] bool empty() const noexcept { return queue_.empty() && turns_.empty(); }
  /// Returns how many frames a newer one replaced in a lane before they were sent.
  [[nodiscard]] std::uint64_t superseded() const noexcept { return superseded_; }

 private:
  std::deque<Frame> queue_;
  std::size_t queued_bytes_ = 0;
  using Turns = std::list<std::uint32_t>;
  struct Lane {
    std::deque<Frame> waiting;
    Turns::iterator turn;  ///< its place in turns_, while a frame waits
  };
  std::unordered_map<std::uint32_t, Lane> lanes_;
  Turns turns_;  ///< the lanes that hold frames, each once, in sending order
  std::uint64_t superseded_ = 0;
  std::function<void(std::size_t)> tell_taken_;
};

}  // namespace galilean::monitor
