// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/record/size_text.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

constexpr Duration kLookEach = std::chrono::seconds(1);

}  // namespace

Recorder::Recorder(Setup setup)
    : setup_(std::move(setup)),
      recordings_(
          {.participant = setup_.participant,
           .selection = setup_.selection,
           .overhears = [this](const wire::EndpointInfo& writer) { return overhears(writer); },
           .warn = setup_.warn,
           .on_data = [this] { wake_.ring(); }}),
      definitions_(setup_.participant, setup_.ended),
      picture_budget_(setup_.picture_bytes_per_s),
      discovery_(setup_.participant) {
  discovery_.on_change([this] {
    writers_changed_ = true;
    wake_.ring();
  });
  if (setup_.snapshots.trigger) ring_.emplace(setup_.snapshots.before, setup_.snapshots.most_bytes);
  wake_.ring();
}

/// States tell which events fill a gap.
bool Recorder::overhears(const wire::EndpointInfo& writer) const {
  if (setup_.snapshots.trigger && setup_.snapshots.trigger->wants(writer)) return true;
  return GapWatch::is_state(writer) && setup_.selection.takes(GapWatch::transitions_of(writer));
}

Result<void> Recorder::begin() {
  return ring_ ? Result<void>() : begin_file(wire::wall_clock_ns());
}

Result<void> Recorder::pump() {
  wake_.clear();
  if (writers_changed_.exchange(false)) recordings_.follow_writers();
  if (auto done = record(); !done) return done;
  const Time now = setup_.clock.now();
  if (ring_)
    if (auto done = follow_events(now); !done) return done;
  if (!looked_ || now - *looked_ >= kLookEach) {
    looked_ = now;
    recordings_.watch_matches();
    say_doubts();
    if (auto done = look_after_files(now); !done) return done;
  }
  if (!setup_.files.is_open()) return {};
  const auto wall_ns = static_cast<std::uint64_t>(wire::wall_clock_ns());
  return setup_.files.writer().close_chunk_if_due(wall_ns);
}

Result<void> Recorder::record() {
  Result<void> done;
  recordings_.take([&](const wire::Received& received, TopicRecording::Writer& writer) {
    if (done) done = take_in(received, writer);
  });
  return done;
}

Result<void> Recorder::take_in(const wire::Received& received, TopicRecording::Writer& writer) {
  const Time now = setup_.clock.now();
  const bool fills_gap = gaps_.note(writer.info, received, now);
  if (!writer.recorded) {
    if (!pause_ && ring_) setup_.snapshots.trigger->take(writer.info, received, now);
    return {};
  }
  if (pause_) return pass_over(received, writer), Result<void>();
  const bool waits = ring_ && !setup_.files.is_open();
  if (ring_) setup_.snapshots.trigger->take(writer.info, received, now);
  if (!waits) kept_.note(writer.info, received);
  if (!waits && !setup_.files.is_open())
    ++writer.unwritten;
  else if (is_picture(writer.info) && !picture_budget_.takes(received.cdr.size(), now))
    ++writer.left_out;
  else
    return keep(received, writer, now, fills_gap);
  return {};
}

/// Writes a message, or keeps it for an event.
Result<void> Recorder::keep(const wire::Received& received, TopicRecording::Writer& writer,
                            Time now, bool fills_gap) {
  if (fills_gap) ++writer.filled;
  if (!ring_ || setup_.files.is_open()) return write(writer.info, received, wire::wall_clock_ns());
  ring_->add(writer.info, received, now, wire::wall_clock_ns());
  return {};
}

/// Begins a file when something has happened, and ends it when its time is over.
Result<void> Recorder::follow_events(Time now) {
  const bool too_much = ring_->forget(
      now, [&](const MessageRing::Held& held) { kept_.note(*held.writer, held.received()); });
  if (too_much)
    warn_once("more came than " + size_text(setup_.snapshots.most_bytes) +
              " in the time that is kept before an event (--keep-memory): less of it is kept");
  const auto event = setup_.snapshots.trigger->happened();
  if (event) {
    snapshot_until_ = now + setup_.snapshots.after;
    if (!setup_.files.is_open()) return begin_snapshot(*event);
  }
  return setup_.files.is_open() && now >= snapshot_until_ ? conclude() : Result<void>();
}

Result<void> Recorder::begin_snapshot(const std::string& event) {
  if (!setup_.room.look()) {
    setup_.warn(event + ": not recorded, because the disk is nearly full");
    return {};
  }
  event_ = event;
  if (!losses_then_.empty()) concluded_ = losses_then_.front().second;
  auto done = begin_file(ring_->empty() ? wire::wall_clock_ns() : ring_->oldest().log_ns);
  ring_->give([&](const MessageRing::Held& held) {
    kept_.note(*held.writer, held.received());
    if (done) done = write(*held.writer, held.received(), held.log_ns);
  });
  if (done) setup_.warn(event + ": recorded to " + setup_.files.newest());
  return done;
}

/// Remembers what was missing when the time began that is kept before an event.
void Recorder::remember_losses(Time now) {
  losses_then_.emplace_back(now, recordings_.losses());
  while (losses_then_.size() > 1 && now - losses_then_[1].first >= setup_.snapshots.before)
    losses_then_.pop_front();
}

Result<void> Recorder::write(const wire::EndpointInfo& writer, const wire::Received& received,
                             std::int64_t log_ns) {
  if (auto done = attach_programs(writer, received); !done) return done;
  if (const auto changed = contents_->program_changes.note(writer, received, log_ns))
    if (auto done = setup_.files.writer().write(*changed); !done) return done;
  return setup_.files.writer().write({contents_->channels.of(writer, received.cdr),
                                      static_cast<std::uint32_t>(received.sequence),
                                      static_cast<std::uint64_t>(log_ns),
                                      static_cast<std::uint64_t>(received.sent_ns), received.cdr});
}

Result<void> Recorder::attach_programs(const wire::EndpointInfo& writer,
                                       const wire::Received& received) {
  for (const auto& [name, text] : contents_->programs.find(writer, received)) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    auto done = setup_.files.writer().write(
        mcap::Attachment{.log_ns = static_cast<std::uint64_t>(wire::wall_clock_ns()),
                         .create_ns = static_cast<std::uint64_t>(received.sent_ns),
                         .name = name,
                         .media_type = "text/plain",
                         .data_bytes = text.size()},
        mcap::MemorySource({bytes, text.size()}));
    if (!done) return done;
  }
  return {};
}

Result<void> Recorder::begin_file(std::int64_t log_ns) {
  const std::size_t files_before = setup_.files.totals().files;
  if (auto done = setup_.files.begin(setup_.clock.now()); !done) return done;
  auto& writer = setup_.files.writer();
  contents_.emplace(
      Contents{Channels({.writer = writer,
                         .definitions = definitions_,
                         .language = setup_.language,
                         .leaves_out_pictures = setup_.picture_bytes_per_s > 0,
                         .warn = [this](const std::string& sentence) { warn_once(sentence); }}),
               LossLog(writer),
               PauseLog(writer),
               {},
               {}});
  mcap::Metadata about{kRecorderMetadata, setup_.about};
  about.entries["started"] = iso_time(wire::wall_clock_ns());
  about.entries["file"] = std::to_string(files_before);
  if (ring_) about.entries["event"] = event_;
  if (auto done = writer.write(about); !done) return done;
  if (auto done = contents_->losses.begin(concluded_); !done) return done;
  return write_kept(log_ns);
}

Result<void> Recorder::write_kept(std::int64_t log_ns, const std::set<std::string>* writers) {
  kept_.forget_all_but(recordings_.present());
  for (const auto& [guid, kept] : kept_.all()) {
    if (writers && !writers->contains(guid)) continue;
    const wire::Received again{kept.cdr, kept.sent_ns, kept.writer.handle, kept.sequence};
    if (auto done = write(kept.writer, again, log_ns); !done) return done;
  }
  return {};
}

void Recorder::say_doubts() {
  if (!setup_.snapshots.trigger) return;
  for (const auto& sentence : setup_.snapshots.trigger->doubts()) warn_once(sentence);
}

void Recorder::warn_once(const std::string& sentence) {
  if (warned_.insert(sentence).second) setup_.warn(sentence);
}

}  // namespace galilean::monitor
