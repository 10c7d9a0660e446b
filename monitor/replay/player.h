// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/clock.h"
#include "monitor/mcap/mcap_scan.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// The speed and the start of a replay.
struct Pace {
  double rate = 1;  ///< 2 is twice as fast as recorded
  Duration from{};  ///< time since the recording's start at which the replay begins
};

/// Sends a recording's messages again, with the intervals in which they were received, divided by
/// the rate.
///
/// If the replay begins later than the recording, it first sends what a late joiner would have got
/// at that time: the newest message of each state and the last 64 of each event.
class Player {
 public:
  using Send = std::function<void(std::uint16_t channel, mcap::ByteView cdr)>;
  /// Waits until the time. Returns false to end the replay.
  using Wait = std::function<bool(Time)>;

  Player(const std::map<std::uint16_t, Track>& tracks, Pace pace, const Clock& clock, Send send,
         Wait wait);

  /// Plays the recording, whose first message is of `start_ns` (since the Unix epoch), on the
  /// calling thread. Leaves out damaged parts and returns them in ScanEnd. Call it once.
  [[nodiscard]] mcap::ScanEnd play(const mcap::ByteSource& recording, std::uint64_t start_ns);
  /// Returns the number of messages that were given to `send`.
  [[nodiscard]] std::uint64_t sent() const noexcept { return sent_; }

 private:
  struct Kept {
    std::uint64_t log_ns;
    std::uint16_t channel;
    mcap::Bytes cdr;
  };

  void meet(const mcap::Message& message);
  void keep(const mcap::Message& message, wire::Delivery delivery);
  void tell_kept();
  void send(std::uint16_t channel, mcap::ByteView cdr);
  [[nodiscard]] Time due(std::uint64_t log_ns) const;

  const std::map<std::uint16_t, Track>& tracks_;
  Pace pace_;
  const Clock& clock_;
  Send send_;
  Wait wait_;
  std::map<std::uint16_t, std::vector<Kept>> kept_;
  std::uint64_t from_ns_ = 0;
  Time began_{};
  bool playing_ = true;
  std::uint64_t sent_ = 0;
};

}  // namespace galilean::monitor
