// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/message_ring.h"

#include <utility>

namespace galilean::monitor {
namespace {

/// What a message takes beside its bytes, roughly.
constexpr std::size_t kOverheadBytes = 128;
constexpr std::size_t kMostForgottenWriters = 1000;

}  // namespace

void MessageRing::add(const wire::EndpointInfo& writer, const wire::Received& received, Time at,
                      std::int64_t log_ns) {
  held_.push_back({shared(writer),
                   at,
                   log_ns,
                   received.sent_ns,
                   received.sequence,
                   {received.cdr.begin(), received.cdr.end()}});
  bytes_ += received.cdr.size() + kOverheadBytes;
}

void MessageRing::pop() {
  bytes_ -= held_.front().cdr.size() + kOverheadBytes;
  held_.pop_front();
}

std::shared_ptr<const wire::EndpointInfo> MessageRing::shared(const wire::EndpointInfo& writer) {
  auto& known = writers_[writer.guid];
  if (auto info = known.lock(); info && info->process == writer.process) return info;
  auto info = std::make_shared<const wire::EndpointInfo>(writer);
  known = info;
  if (writers_.size() > kMostForgottenWriters)
    std::erase_if(writers_, [](const auto& each) { return each.second.expired(); });
  return info;
}

}  // namespace galilean::monitor
