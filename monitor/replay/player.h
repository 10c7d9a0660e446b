// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "core/clock.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/playback/late_joiner.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// The speed, the start and the end of a replay.
struct Pace {
  double rate = 1;  ///< 2 is twice as fast as recorded
  Duration from{};  ///< time since the recording's start at which the replay begins
  std::optional<Duration> until = std::nullopt;  ///< and at which it ends
};

/// Sends a recording's messages again in the order of their log times, with the intervals in which
/// they were received, divided by the rate. A silence over mcap::kLongestSilence_ns is no part of
/// the recording's time: the replay goes on at once.
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

  /// Plays the recording, whose messages are in `blocks`, on the calling thread. Leaves out damaged
  /// parts and returns them. Call it once.
  [[nodiscard]] std::vector<mcap::Damage> play(const mcap::ByteSource& recording,
                                               const std::vector<mcap::Block>& blocks);
  /// Returns the number of messages that were given to `send`.
  [[nodiscard]] std::uint64_t sent() const noexcept { return sent_; }
  /// Returns where in the recording the newest message is [since its start, without silences].
  [[nodiscard]] Duration position() const noexcept {
    return Duration(static_cast<Duration::rep>(time_.position_ns()));
  }
  /// Returns which time of the recording it is now [log time, ns since the Unix epoch], which goes
  /// on between messages but not beyond the next one. Returns nothing before the first message.
  [[nodiscard]] std::optional<std::uint64_t> log_now_ns() const;
  /// Returns the silences that were passed over.
  [[nodiscard]] const std::vector<mcap::TimeRange>& silences() const noexcept {
    return time_.silences();
  }

 private:
  void meet(const mcap::Message& message);
  void tell_kept();
  void send(std::uint16_t channel, mcap::ByteView cdr);
  [[nodiscard]] Time due() const;

  const std::map<std::uint16_t, Track>& tracks_;
  Pace pace_;
  const Clock& clock_;
  Send send_;
  Wait wait_;
  LateJoiner kept_;
  mcap::RecordingTime time_;
  Time began_{};
  bool playing_ = true;
  std::uint64_t sent_ = 0;
};

}  // namespace galilean::monitor
