// SPDX-License-Identifier: BSD-3-Clause
// How a recorder looks after its files: whether they are there, there is room, and it is time for
// another.
#include <algorithm>

#include "core/wire/ros_time.h"
#include "monitor/record/recorder.h"
#include "monitor/record/size_text.h"

namespace galilean::monitor {

/// Tells what was lost, goes on in another file, and looks whether there is room.
Result<void> Recorder::look_after_files(Time now) {
  if (auto done = watch_file(); !done) return done;
  const bool has_room = setup_.room.look();
  if (!setup_.files.is_open() && ring_) return remember_losses(now), Result<void>();
  if (!setup_.files.is_open()) {
    if (!has_room || pause_) return {};
    setup_.warn("there is room on the disk again: the recording goes on");
    return begin_file(wire::wall_clock_ns());
  }
  if (!has_room) return stand_still();
  if (auto done = contents_->losses.tell(recordings_.losses(), wire::wall_clock_ns()); !done)
    return done;
  if (pause_ || !setup_.files.is_full(now)) return {};
  if (auto done = conclude(); !done) return done;
  return begin_file(wire::wall_clock_ns());
}

/// Errors: the file was deleted or spoilt. Where it is only called otherwise, it is written on.
Result<void> Recorder::watch_file() {
  if (auto done = setup_.files.check(); !done) return done;
  if (setup_.files.has_moved())
    warn_once(setup_.files.newest() +
              " is no longer there: the recording goes on in the file that had this name");
  return {};
}

Result<void> Recorder::stand_still() {
  setup_.warn("only " + size_text(setup_.room.free()) + " are free for '" +
              setup_.files.plan().out + "', less than " + size_text(setup_.room.least()) +
              " (--min-free): nothing is recorded until there is room again; delete something");
  if (auto done = write_end(); !done) return done;
  return ring_ ? setup_.files.end() : setup_.files.set_aside();
}

/// Nobody could tell from the last file what came after it, if there is no other.
void Recorder::tell_what_came_since() {
  const auto losses = recordings_.losses();
  if (!setup_.files.can_amend() || total_missing(losses) == total_missing(concluded_)) return;
  if (auto done = setup_.files.amend(losses_metadata(kLossesMetadata, losses)); !done)
    setup_.warn("what is missing is not told in the file: " + done.error().message);
}

Result<void> Recorder::conclude() {
  say_doubts();
  if (!setup_.files.is_open()) {
    if (auto done = setup_.files.check(); !done) return done;
    tell_what_came_since();
    return {};
  }
  if (auto done = watch_file(); !done) return done;
  if (auto done = write_end(); !done) return done;
  return setup_.files.end();
}

Result<void> Recorder::write_end() {
  concluded_ = recordings_.losses();
  if (pause_) {
    auto until_now = *pause_;
    until_now.to_ns = std::max(pause_->from_ns, wire::wall_clock_ns());
    if (auto done = contents_->pauses.tell(until_now); !done) return done;
  }
  if (auto done = contents_->pauses.conclude(); !done) return done;
  if (auto done = contents_->losses.conclude(concluded_); !done) return done;
  contents_.reset();
  losses_then_.clear();
  return {};
}

}  // namespace galilean::monitor
