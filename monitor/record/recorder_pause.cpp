// SPDX-License-Identifier: BSD-3-Clause
// How a recorder pauses and goes on.
#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/record/recorder.h"

namespace galilean::monitor {

void Recorder::pass_over(const wire::Received& received, TopicRecording::Writer& writer) {
  kept_.note(writer.info, received);
  changed_in_pause_.insert(writer.info.guid);
  writer.paused.note(pauses_, writer.tally);
  ++pause_->messages;
}

Result<void> Recorder::pause(const std::string& by) {
  if (pause_) return {};
  if (auto done = record(); !done) return done;
  if (ring_)
    ring_->give([&](const MessageRing::Held& held) { kept_.note(*held.writer, held.received()); });
  ++pauses_;
  pause_ = Pause{.from_ns = wire::wall_clock_ns(), .to_ns = {}, .messages = 0, .by = by};
  return setup_.files.is_open() ? contents_->pauses.tell(*pause_) : Result<void>();
}

Result<std::optional<Pause>> Recorder::resume() {
  if (!pause_) return std::optional<Pause>();
  if (auto done = record(); !done) return done.error();
  pause_->to_ns = std::max(pause_->from_ns, wire::wall_clock_ns());
  const auto ended = std::exchange(pause_, std::nullopt);
  const auto changed = std::exchange(changed_in_pause_, {});
  if (!setup_.files.is_open()) return ended;
  if (auto done = contents_->pauses.tell(*ended); !done) return done.error();
  contents_->channels.begin_part();
  if (auto done = write_kept(*ended->to_ns, &changed); !done) return done.error();
  return ended;
}

}  // namespace galilean::monitor
