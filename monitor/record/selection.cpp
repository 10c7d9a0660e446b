// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/selection.h"

#include <algorithm>
#include <string>

#include "core/wire/messages.h"
#include "monitor/record/recorder_topics.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

bool is_left_out(const wire::EndpointInfo& picture, Pictures pictures) {
  if (pictures == Pictures::kCamera) return !picture.topic.ends_with("/camera/compressed");
  return pictures == Pictures::kNone;
}

bool matches_any(const std::vector<std::regex>& expressions, const std::string& name) {
  return std::ranges::any_of(expressions,
                             [&](const std::regex& each) { return std::regex_search(name, each); });
}

}  // namespace

bool is_picture(const wire::EndpointInfo& writer) {
  return shown_type(writer.dds_type) == msg::CompressedImage::kRosType;
}

bool is_inputs(const wire::EndpointInfo& writer) {
  return shown_type(writer.dds_type) == msg::TickInputs::kRosType;
}

bool is_service(std::string_view topic) noexcept {
  return topic.starts_with("rq/") || topic.starts_with("rr/");
}

bool is_of_recorders(std::string_view topic) noexcept {
  return topic == kRecorderCommandTopic || topic == kRecorderStatusTopic;
}

bool Selection::takes(const wire::EndpointInfo& writer) const {
  if (is_service(writer.topic) || is_of_recorders(writer.topic)) return false;
  if (wants && !wants(writer)) return false;
  if (is_inputs(writer) && !inputs) return false;
  if (is_picture(writer) && is_left_out(writer, pictures)) return false;
  const std::string name = shown_topic(writer.topic);
  if (excludes(name)) return false;
  return topics.empty() || is_inputs(writer) || matches_any(topics, name);
}

bool Selection::excludes(const std::string& name) const {
  return matches_any(excluded, name);
}

bool Selection::excludes_inputs_of_all() const {
  constexpr const char* kOfNoRobotThatThereIs = "/q0_q0/inputs";
  return excludes(kOfNoRobotThatThereIs);
}

}  // namespace galilean::monitor
