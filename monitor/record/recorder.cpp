// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

constexpr Duration kLookEach = std::chrono::seconds(1);

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(bytes / 1'000'000) + " MB";
}

}  // namespace

Recorder::Recorder(Setup setup)
    : setup_(std::move(setup)),
      recordings_({.participant = setup_.participant,
                   .selection = setup_.selection,
                   .warn = setup_.warn,
                   .on_data = [this] { wake_.ring(); }}),
      definitions_(setup_.participant, setup_.ended),
      picture_budget_(setup_.picture_bytes_per_s),
      discovery_(setup_.participant) {
  discovery_.on_change([this] {
    writers_changed_ = true;
    wake_.ring();
  });
  wake_.ring();
}

Result<void> Recorder::pump() {
  wake_.clear();
  if (writers_changed_.exchange(false)) recordings_.follow_writers();
  if (auto done = record(); !done) return done;
  const Time now = setup_.clock.now();
  if (!looked_ || now - *looked_ >= kLookEach) {
    looked_ = now;
    recordings_.watch_matches();
    if (auto done = look_after_files(now); !done) return done;
  }
  if (!setup_.files.is_open()) return {};
  const auto wall_ns = static_cast<std::uint64_t>(wire::wall_clock_ns());
  return setup_.files.writer().close_chunk_if_due(wall_ns);
}

Result<void> Recorder::record() {
  Result<void> done;
  recordings_.take([&](const wire::Received& received, TopicRecording::Writer& writer) {
    kept_.note(writer.info, received);
    if (!setup_.files.is_open())
      ++writer.unwritten;
    else if (is_picture(writer.info) &&
             !picture_budget_.takes(received.cdr.size(), setup_.clock.now()))
      ++writer.left_out;
    else if (done)
      done = write(writer.info, received);
  });
  return done;
}

Result<void> Recorder::write(const wire::EndpointInfo& writer, const wire::Received& received) {
  if (auto done = attach_programs(writer, received); !done) return done;
  return setup_.files.writer().write({contents_->channels.of(writer, received.cdr),
                                      static_cast<std::uint32_t>(received.sequence),
                                      static_cast<std::uint64_t>(wire::wall_clock_ns()),
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

/// Tells what was lost, goes on in another file, and looks whether there is room.
Result<void> Recorder::look_after_files(Time now) {
  const bool has_room = setup_.room.look();
  if (!setup_.files.is_open()) {
    if (!has_room) return {};
    setup_.warn("there is room on the disk again: the recording goes on");
    return begin_file();
  }
  if (!has_room) return stand_still();
  if (auto done = contents_->losses.tell(recordings_.losses(), wire::wall_clock_ns()); !done)
    return done;
  if (!setup_.files.is_full(now)) return {};
  if (auto done = conclude(); !done) return done;
  return begin_file();
}

Result<void> Recorder::stand_still() {
  setup_.warn("only " + megabytes(setup_.room.free()) + " are free for '" +
              setup_.files.plan().out + "', less than " + megabytes(setup_.room.least()) +
              " (--min-free): nothing is recorded until there is room again; delete something");
  return conclude();
}

Result<void> Recorder::begin_file() {
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
               {}});
  mcap::Metadata about{"galilean", setup_.about};
  about.entries["started"] = iso_time(wire::wall_clock_ns());
  about.entries["file"] = std::to_string(files_before);
  if (auto done = writer.write(about); !done) return done;
  if (auto done = contents_->losses.begin(concluded_); !done) return done;
  return write_kept();
}

Result<void> Recorder::write_kept() {
  kept_.forget_all_but(recordings_.present());
  for (const auto& [guid, kept] : kept_.all()) {
    const wire::Received again{kept.cdr, kept.sent_ns, kept.writer.handle, kept.sequence};
    if (auto done = write(kept.writer, again); !done) return done;
  }
  return {};
}

Result<void> Recorder::conclude() {
  if (!setup_.files.is_open()) return {};
  concluded_ = recordings_.losses();
  if (auto done = contents_->losses.conclude(concluded_); !done) return done;
  contents_.reset();
  return setup_.files.end();
}

void Recorder::warn_once(const std::string& sentence) {
  if (warned_.insert(sentence).second) setup_.warn(sentence);
}

}  // namespace galilean::monitor
