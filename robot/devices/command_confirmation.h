// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/clock.h"

namespace galilean::robot {

/// Knows whether the board takes the commands that the line took. A line that blocks takes bytes
/// for seconds, and the board may still send; only the sequence that its Status tells shows what it
/// has read. One command is awaited at a time, and any later one confirms it too: a frame that was
/// lost is not missed.
class CommandConfirmation {
 public:
  /// Forgets all, because a session begins.
  void reset() { *this = {}; }
  /// Notes the sequence of the command that the line took last.
  void note_written(std::optional<std::uint16_t> last_written, Time now) {
    last_written_ = last_written;
    if (awaited_ || !last_written_ || last_written_ == confirmed_) return;
    awaited_ = last_written_;
    since_ = now;
  }
  /// Notes the sequence of the command that the board accepted last.
  void note_accepted(std::uint16_t last_accepted) {
    if (!awaited_ || !last_written_) return;
    // Sequences wrap around, and the board may still tell one of another session.
    const auto later = static_cast<std::uint16_t>(last_accepted - *awaited_);
    const auto latest = static_cast<std::uint16_t>(*last_written_ - *awaited_);
    if (later > latest) return;
    confirmed_ = last_accepted;
    awaited_.reset();
  }
  /// Returns whether a command was written and is not confirmed yet.
  [[nodiscard]] bool missing() const { return awaited_.has_value(); }
  /// Returns whether that has been so for longer than `duration`.
  [[nodiscard]] bool missing_for(Duration duration, Time now) const {
    return awaited_ && now - since_ > duration;
  }

 private:
  std::optional<std::uint16_t> last_written_;
  std::optional<std::uint16_t> awaited_;
  std::optional<std::uint16_t> confirmed_;
  Time since_{};
};

}  // namespace galilean::robot
