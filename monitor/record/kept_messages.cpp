// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/kept_messages.h"

#include <set>

namespace galilean::monitor {

void KeptMessages::note(const wire::EndpointInfo& writer, const wire::Received& received) {
  using Durability = wire::EndpointQos::Durability;
  // Those that keep several send events, which must not happen a second time.
  if (writer.qos.durability < Durability::kTransientLocal || writer.qos.depth != 1) return;
  Kept& kept = kept_[writer.guid];
  kept.writer = writer;
  kept.sequence = received.sequence;
  kept.sent_ns = received.sent_ns;
  kept.cdr.assign(received.cdr.begin(), received.cdr.end());
}

void KeptMessages::forget_all_but(const std::vector<wire::EndpointInfo>& present) {
  std::set<std::string> guids;
  for (const auto& end : present) guids.insert(end.guid);
  std::erase_if(kept_, [&](const auto& each) { return !guids.contains(each.first); });
}

}  // namespace galilean::monitor
