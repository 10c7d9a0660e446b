// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/match_watch.h"

#include "core/visible_text.h"
#include "monitor/wire/qos_report.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

constexpr int kPatience = 5;

std::string unheard_writer(const wire::EndpointInfo& writer) {
  wire::EndpointInfo reader = writer;
  reader.writes = false;
  reader.qos = TopicRecording::asked_of(writer);
  std::string text = "'" + visible(shown_topic(writer.topic)) + "' of " + visible(writer.process) +
                     " is not recorded: DDS does not connect its writer (" +
                     qos_text(qos_tree(writer.qos)) + ") with the recorder's reader (" +
                     qos_text(qos_tree(reader.qos)) + ")";
  for (const auto& reason : mismatches(writer, reader)) text += "; " + visible(reason);
  return text;
}

}  // namespace

std::optional<std::string> MatchWatch::look(const wire::EndpointInfo& writer,
                                            const TopicRecording& recording) {
  if (recording.hears(writer)) {
    unheard_.erase(writer.guid);
    return std::nullopt;
  }
  if (++unheard_[writer.guid] != kPatience) return std::nullopt;
  return unheard_writer(writer);
}

}  // namespace galilean::monitor
