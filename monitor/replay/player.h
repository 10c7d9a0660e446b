// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/clock.h"
#include "monitor/mcap/mcap_scan.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// How a recording is played.
struct Pace {
  double rate = 1;  ///< 2: twice as fast as it was
  Duration from{};  ///< what was before this, since its start, is not played
};

/// Sends a recording's messages again, each as long after the first as it was received then.
///
/// Where it begins later than the recording, what a late joiner would have been told then comes
/// first: the newest of what is, the last of what happened.
class Player {
 public:
  using Send = std::function<void(std::uint16_t channel, mcap::ByteView cdr)>;
  /// Waits until then; false ends the playing.
  using Wait = std::function<bool(Time)>;

  Player(const std::map<std::uint16_t, Track>& tracks, Pace pace, const Clock& clock, Send send,
         Wait wait);

  /// Plays what is whole, from its start at `start_ns` (since the Unix epoch). What could not be
  /// read is told.
  [[nodiscard]] mcap::ScanEnd play(const mcap::ByteSource& recording, std::uint64_t start_ns);
  /// Sent in all.
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
