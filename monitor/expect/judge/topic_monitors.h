// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "monitor/expect/judge/finding.h"
#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// Watches when one topic's messages come.
class TopicMonitor {
 public:
  virtual ~TopicMonitor() = default;
  void message(std::int64_t at_ns, std::uint32_t sequence);
  /// Returns what it found until `end_ns`. Call it once, after the last message.
  [[nodiscard]] Finding finish(std::int64_t end_ns);

 protected:
  virtual void step(std::int64_t at_ns, std::uint32_t sequence) = 0;
  virtual void conclude(std::int64_t end_ns, Finding& finding) = 0;
  void fail(std::int64_t at_ns, std::string values, std::optional<Span> needs = {});

  std::uint64_t count_ = 0;
  std::int64_t first_ns_ = 0, newest_ns_ = 0;  ///< `newest_ns_` is the one before, in a step
  Finding finding_;
};

/// Returns the monitor of a claim about a topic, or nullptr if the claim is about conditions.
[[nodiscard]] std::unique_ptr<TopicMonitor> make_topic_monitor(const Claim& claim);
/// Returns the topic that a claim is about, or nullptr.
[[nodiscard]] const TopicName* topic_of(const Claim& claim);

}  // namespace galilean::expect
