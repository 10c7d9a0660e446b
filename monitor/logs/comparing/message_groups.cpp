// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/message_groups.h"

#include "monitor/record/damage_text.h"

namespace galilean::logs {

bool OwnedMessage::equals(const OwnedMessage& other) const {
  return topic == other.topic && sequence == other.sequence &&
         head.publish_ns == other.head.publish_ns && data == other.data;
}

Result<std::vector<OwnedMessage>> MessageGroups::take() {
  std::vector<OwnedMessage> group;
  const auto& recording = messages_.recording();
  const std::uint64_t log_ns = next_->log_ns;
  for (; next_ && next_->log_ns == log_ns; next_ = messages_.next()) {
    if (group.size() == kMost)
      return Error{recording.path() + " has more than " + std::to_string(kMost) +
                   " messages of one time"};
    group.push_back({monitor::topic_of(next_->channel_id, recording.summary()),
                     next_->sequence,
                     messages_.at_s(),
                     *next_,
                     {next_->data.begin(), next_->data.end()}});
  }
  return group;
}

}  // namespace galilean::logs
