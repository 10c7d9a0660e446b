// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/chunk_builder.h"

#include <algorithm>

namespace galilean::mcap {

void ChunkBuilder::add(const Message& message) {
  MessageIndex& index = indexes_[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.push_back({message.log_ns, records_.size()});
  start_ns_ = has_message_ ? std::min(start_ns_, message.log_ns) : message.log_ns;
  end_ns_ = std::max(end_ns_, message.log_ns);
  has_message_ = true;
  append(records_, message);
}

void ChunkBuilder::clear() {
  records_.clear();
  for (auto& [channel, index] : indexes_) index.entries.clear();
  has_message_ = false;
  start_ns_ = end_ns_ = 0;
}

}  // namespace galilean::mcap
