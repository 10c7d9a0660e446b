// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/topic_recordings.h"

#include <algorithm>
#include <exception>
#include <string_view>

#include "core/visible_text.h"
#include "core/wire/delivery.h"
#include "monitor/record/gap_watch.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

/// The number of messages of each reader that may wait while a chunk is compressed and written. It
/// is a minute of a robot's state or six seconds of pictures.
constexpr int kReaderDepth = 600, kPictureDepth = 60;
/// What a robot kept while it could not be heard comes at once.
constexpr int kEventDepth = wire::kJournalDepth + kReaderDepth;

int depth_of(const wire::EndpointInfo& writer) {
  if (is_picture(writer)) return kPictureDepth;
  return is_robot_event(writer) ? kEventDepth : kReaderDepth;
}

WriterLosses losses_of(const TopicRecording::Kind& kind, const TopicRecording::Writer& writer) {
  const auto lost = writer.tally.lost() - writer.paused.lost();
  return {.topic = visible(shown_topic(kind.topic)),
          .process = visible(writer.info.process),
          .writer = writer.info.guid,
          .recorded =
              writer.tally.received() - writer.unwritten - writer.left_out - writer.paused.came(),
          .filled = writer.filled,
          .lost = kind.keyed ? std::nullopt : std::optional(lost),
          .overrun = std::min(writer.overrun, lost),
          .sent_before = writer.tally.sent_before(),
          .unwritten = writer.unwritten,
          .left_out = writer.left_out,
          .paused = writer.paused.came() + writer.paused.lost()};
}

}  // namespace

void TopicRecordings::follow_writers() {
  for (const auto& end : endpoints_.known()) {
    if (!end.writes) continue;
    const bool selected = setup_.selection.takes(end);
    if (selected || (setup_.overhears && setup_.overhears(end))) follow(end);
    if (!selected)
      left_out_topics_ =
          left_out_topics_ || (!is_service(end.topic) && !is_of_recorders(end.topic));
  }
}

void TopicRecordings::follow(const wire::EndpointInfo& writer) try {
  if (!refused_.contains(writer.guid)) recording_of(writer).follow(writer);
} catch (const std::exception& error) {
  refused_.insert(writer.guid);
  setup_.warn("'" + visible(shown_topic(writer.topic)) + "' of " + visible(writer.process) +
              " is not recorded: " + error.what());
}

TopicRecording& TopicRecordings::recording_of(const wire::EndpointInfo& writer) {
  auto& recording = recordings_[TopicRecording::kind_of(writer)];
  if (!recording)
    recording = std::make_unique<TopicRecording>(
        TopicRecording::Setup{.participant = setup_.participant,
                              .kind = TopicRecording::kind_of(writer),
                              .recorded = setup_.selection.takes(writer),
                              .depth = depth_of(writer),
                              .find = [this](std::uint64_t handle) { return find_writer(handle); },
                              .on_data = setup_.on_data});
  return *recording;
}

std::optional<wire::EndpointInfo> TopicRecordings::find_writer(std::uint64_t handle) {
  for (const auto& end : endpoints_.known())
    if (end.handle == handle) return end;
  return std::nullopt;
}

void TopicRecordings::take(const TopicRecording::Receive& receive) {
  for (const auto& [kind, recording] : recordings_) recording->take(receive);
}

void TopicRecordings::watch_matches() {
  for (const auto& end : endpoints_.known()) {
    const auto* recording = find_recording(end);
    if (!recording) continue;
    if (const auto sentence = matches_.look(end, *recording)) setup_.warn(*sentence);
  }
}

/// Returns nullptr if the end is no writer that is followed.
const TopicRecording* TopicRecordings::find_recording(const wire::EndpointInfo& end) const {
  if (!end.writes || refused_.contains(end.guid)) return nullptr;
  const auto found = recordings_.find(TopicRecording::kind_of(end));
  if (found == recordings_.end() || !found->second->writers().contains(end.guid)) return nullptr;
  return found->second.get();
}

std::size_t TopicRecordings::topics() const {
  std::set<std::string_view> names;
  for (const auto& [kind, recording] : recordings_)
    if (recording->recorded()) names.insert(kind.topic);
  return names.size();
}

std::vector<WriterLosses> TopicRecordings::losses() const {
  std::vector<WriterLosses> all;
  for (const auto& [kind, recording] : recordings_) {
    if (!recording->recorded()) continue;
    for (const auto& [guid, writer] : recording->writers()) all.push_back(losses_of(kind, writer));
  }
  return all;
}

}  // namespace galilean::monitor
