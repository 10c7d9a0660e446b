// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/clock.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/playback/recording_cursor.h"
#include "monitor/playback/replay_clock.h"
#include "monitor/playback/silences.h"

namespace galilean::monitor {

/// Plays a recording to one viewer, who pauses it, goes to any instant and changes the speed. It
/// never waits itself: its owner asks which message is due, and how long until the next one.
///
/// The time of the playback is the log time of messages. It never runs ahead of a message that was
/// not taken yet: where the owner, the disk or the viewer is slow, it waits. It passes over a
/// silence at once. For use by one thread.
class SeekablePlayer {
 public:
  static constexpr double kLeastSpeed = 0.1, kMostSpeed = 100;

  enum class Status { kPlaying, kPaused, kEnded };

  /// Begins to play at the recording's start.
  /// Requires: `source`, `summary`, `topics` and `real` outlive this, and the recording has
  /// messages.
  SeekablePlayer(const mcap::ByteSource& source, const mcap::Summary& summary,
                 const std::vector<RecordedTopic>& topics, const Clock& real);

  void pause(bool paused);
  /// Requires: `speed` is from kLeastSpeed to kMostSpeed.
  void set_speed(double speed) { clock_.set_rate(speed); }
  /// Goes to an instant [log time, ns since the Unix epoch]; to the start or the end if it is
  /// outside of the recording.
  void seek(std::uint64_t at_ns);
  /// Replaces the wanted channels of the recording. How things stand now is told first of those
  /// that are new, also while it is paused.
  void want(RecordingCursor::Channels channels);

  /// Returns the message that is due now, until take() or another change; nullptr if none is.
  [[nodiscard]] const mcap::Message* due();
  /// Passes over the message that due() returned.
  void take();
  /// Returns how long it takes until due() may return another message; nothing if it does not
  /// before something is changed.
  [[nodiscard]] std::optional<Duration> until_next();

  [[nodiscard]] Status status() const noexcept;
  [[nodiscard]] double speed() const noexcept { return clock_.rate(); }
  /// Returns the time of the playback [log time, ns since the Unix epoch].
  [[nodiscard]] std::uint64_t now_ns() const noexcept;
  /// Returns the log times of the recording's first and last message.
  [[nodiscard]] std::uint64_t start_ns() const noexcept { return start_ns_; }
  [[nodiscard]] std::uint64_t end_ns() const noexcept { return end_ns_; }
  /// Returns the damage that was met since the last call.
  [[nodiscard]] std::vector<mcap::Damage> take_damages() { return cursor_.take_damages(); }

 private:
  [[nodiscard]] Time time_of(std::uint64_t log_ns) const noexcept;
  [[nodiscard]] std::uint64_t clock_ns() const noexcept;
  [[nodiscard]] std::uint64_t resume_ns();
  [[nodiscard]] bool is_behind_silence(const mcap::Message& next) const;
  void keep_time_with(const mcap::Message& next);
  void end_if_over();

  std::uint64_t start_ns_, end_ns_;
  Silences silences_;
  RecordingCursor cursor_;
  ReplayClock clock_;
  bool paused_ = false, ended_ = false;
  std::optional<std::uint64_t>
      taken_ns_;  ///< of the newest message that was taken, not of a past one
};

}  // namespace galilean::monitor
