// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <exception>
#include <string_view>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

/// The number of messages of each reader that may wait while a chunk is compressed and written. It
/// is a minute of a robot's state or six seconds of images.
constexpr int kReaderDepth = 600, kImageDepth = 60;
/// Requests to and replies of the services of ROS 2 are no topics.
constexpr std::string_view kServicePrefixes[] = {"rq/", "rr/"};
constexpr std::int64_t kLossesEach_ns = 1'000'000'000;

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
      channels_(setup_.writer, definitions_, setup_.selection.language, setup_.warn),
      loss_log_(setup_.writer),
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
  if (auto done = tell_losses(); !done) return done;
  return setup_.writer.close_chunk_if_due(static_cast<std::uint64_t>(wire::wall_clock_ns()));
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
  recording.take([&](const wire::Received& received, const TopicRecording::Writer& writer) {
    if (!done) return;
    done = setup_.writer.write({channels_.of(writer.info),
                                static_cast<std::uint32_t>(received.sequence),
                                static_cast<std::uint64_t>(wire::wall_clock_ns()),
                                static_cast<std::uint64_t>(received.sent_ns), received.cdr});
  });
  return done;
}

Result<void> Recorder::tell_losses() {
  const std::int64_t now_ns = wire::wall_clock_ns();
  if (now_ns - losses_told_ns_ < kLossesEach_ns) return {};
  losses_told_ns_ = now_ns;
  return loss_log_.tell(losses(), now_ns);
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
                     .recorded = writer.tally.received(),
                     .lost = kind.keyed ? std::nullopt : std::optional(writer.tally.lost()),
                     .sent_before = writer.tally.sent_before()});
  return all;
}

}  // namespace galilean::monitor
