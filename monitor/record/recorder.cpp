// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <exception>
#include <string_view>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/record/times.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

/// The number of messages of each reader that may wait while a chunk is compressed and written. It
/// is a minute of a robot's state or six seconds of images.
constexpr int kReaderDepth = 600, kImageDepth = 60;
/// Requests to and replies of the services of ROS 2 are no topics.
constexpr std::string_view kServicePrefixes[] = {"rq/", "rr/"};
constexpr std::int64_t kLookEach_ns = 1'000'000'000;

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(bytes / 1'000'000) + " MB";
}

bool is_image(const wire::EndpointInfo& writer) {
  return shown_type(writer.dds_type) == msg::CompressedImage::kRosType;
}

bool is_service(std::string_view topic) {
  for (const auto prefix : kServicePrefixes)
    if (topic.starts_with(prefix)) return true;
  return false;
}

}  // namespace

Recorder::Recorder(Setup setup)
    : setup_(std::move(setup)),
      endpoints_(setup_.participant),
      definitions_(setup_.participant, setup_.ended),
      discovery_(setup_.participant) {
  discovery_.on_change([this] {
    writers_changed_ = true;
    wake_.ring();
  });
  wake_.ring();
}

Result<void> Recorder::pump() {
  wake_.clear();
  if (writers_changed_.exchange(false)) follow_writers();
  for (const auto& [kind, recording] : recordings_)
    if (auto done = record(*recording); !done) return done;
  if (auto done = look_after_files(); !done) return done;
  if (!setup_.files.is_open()) return {};
  const auto now_ns = static_cast<std::uint64_t>(wire::wall_clock_ns());
  return setup_.files.writer().close_chunk_if_due(now_ns);
}

bool Recorder::is_selected(const wire::EndpointInfo& writer) const {
  const auto& [topics, images, language] = setup_.selection;
  if (!images && is_image(writer)) return false;
  return !topics || std::regex_search(shown_topic(writer.topic), *topics);
}

void Recorder::follow_writers() {
  for (const auto& end : endpoints_.known()) {
    if (!end.writes || is_service(end.topic)) continue;
    if (is_selected(end))
      follow(end);
    else
      left_out_.insert(end.topic);
  }
}

void Recorder::follow(const wire::EndpointInfo& writer) try {
  const auto kind = TopicRecording::kind_of(writer);
  if (refused_.contains(kind)) return;
  auto& recording = recordings_[kind];
  if (!recording)
    recording = std::make_unique<TopicRecording>(setup_.participant, kind,
                                                 is_image(writer) ? kImageDepth : kReaderDepth,
                                                 [this] { wake_.ring(); });
  recording->follow(writer);
} catch (const std::exception& error) {
  const auto kind = TopicRecording::kind_of(writer);
  refused_.insert(kind);
  recordings_.erase(kind);
  setup_.warn("'" + visible(shown_topic(writer.topic)) + "' of " + visible(writer.process) +
              " is not recorded: " + error.what());
}

Result<void> Recorder::record(TopicRecording& recording) {
  Result<void> done;
  recording.take([&](const wire::Received& received, TopicRecording::Writer& writer) {
    if (!setup_.files.is_open()) ++writer.unwritten;
    if (!done || !setup_.files.is_open()) return;
    done = setup_.files.writer().write({contents_->channels.of(writer.info),
                                        static_cast<std::uint32_t>(received.sequence),
                                        static_cast<std::uint64_t>(wire::wall_clock_ns()),
                                        static_cast<std::uint64_t>(received.sent_ns),
                                        received.cdr});
  });
  return done;
}

/// Each second: tells what was lost, goes on in another file, and looks whether there is room.
Result<void> Recorder::look_after_files() {
  const std::int64_t now_ns = wire::wall_clock_ns();
  if (now_ns - looked_ns_ < kLookEach_ns) return {};
  looked_ns_ = now_ns;
  const bool has_room = setup_.room.look();
  if (!setup_.files.is_open()) return has_room ? begin_file() : Result<void>();
  if (!has_room) return stand_still();
  if (auto done = contents_->losses.tell(losses(), now_ns); !done) return done;
  if (!setup_.files.is_full(now_ns)) return {};
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
  const std::int64_t now_ns = wire::wall_clock_ns();
  const bool again = setup_.files.totals().files > 0;
  if (auto done = setup_.files.begin(now_ns); !done) return done;
  auto& writer = setup_.files.writer();
  contents_.emplace(Contents{{writer, definitions_, setup_.selection.language, setup_.warn},
                             LossLog(writer)});
  mcap::Metadata about{"galilean", setup_.about};
  about.entries["started"] = iso_time(now_ns);
  if (again) about.entries["file"] = std::to_string(setup_.files.totals().files - 1);
  return writer.write(about);
}

Result<void> Recorder::conclude() {
  if (!setup_.files.is_open()) return {};
  if (auto done = contents_->losses.conclude(losses()); !done) return done;
  contents_.reset();
  return setup_.files.end();
}

std::size_t Recorder::topics() const {
  std::set<std::string_view> names;
  for (const auto& [kind, recording] : recordings_) names.insert(kind.topic);
  return names.size();
}

std::vector<WriterLosses> Recorder::losses() const {
  std::vector<WriterLosses> all;
  for (const auto& [kind, recording] : recordings_)
    for (const auto& [guid, writer] : recording->writers())
      all.push_back({.topic = visible(shown_topic(kind.topic)),
                     .process = visible(writer.info.process),
                     .recorded = writer.tally.received() - writer.unwritten,
                     .lost = kind.keyed ? std::nullopt : std::optional(writer.tally.lost()),
                     .sent_before = writer.tally.sent_before(),
                     .unwritten = writer.unwritten});
  return all;
}

}  // namespace galilean::monitor
