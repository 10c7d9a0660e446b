// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/topic_monitor.h"

#include <algorithm>
#include <utility>

#include "core/plural.h"

namespace galilean::expect {

void TopicMonitor::message(std::int64_t at_ns, const Numbered& number) {
  if (count_++ == 0) first_ns_ = at_ns;
  gaps_.note(at_ns, number);
  step(at_ns);
  newest_ns_ = at_ns;
}

void TopicMonitor::missed(std::optional<std::uint64_t> messages) {
  was_counted_ = true;
  counted_ = messages;
}

std::uint64_t TopicMonitor::missing() const noexcept {
  const std::uint64_t between = gaps_.tells() ? gaps_.missing() : 0;
  return std::max(between, counted_.value_or(0));
}

std::string TopicMonitor::missing_text() const {
  return plural(missing(), "message") + agreeing(missing(), " is", " are") + " missing";
}

void TopicMonitor::doubt_times() {
  if (missing() == 0) return;
  finding_.outcome = finding_.failures > 0 ? Outcome::kFails : Outcome::kHolds;
  SpanList anywhere;
  anywhere.add(kAnyTime);
  const bool all_have_times = gaps_.tells() && missing() == gaps_.missing();
  doubt_where(all_have_times ? gaps_.times() : anywhere, missing_text(), finding_);
  if (finding_.outcome == Outcome::kCannotTell) finding_.failures = 0;
}

std::string TopicMonitor::doubt() const {
  if (!was_counted_) return gaps_.doubt();
  return counted_ ? "" : "its recorder could not count what is missing of it";
}

void TopicMonitor::cannot_tell(std::string reason) {
  finding_.outcome = Outcome::kCannotTell;
  finding_.reason = std::move(reason);
}

Finding TopicMonitor::finish(std::int64_t end_ns) {
  if (count_ == 0) {
    finding_.reason = "nothing came on the topic";
    return std::move(finding_);
  }
  finding_.outcome = Outcome::kHolds;
  conclude(end_ns, finding_);
  if (finding_.failures > 0) finding_.outcome = Outcome::kFails;
  lift_limits({first_ns_, end_ns}, finding_);
  return std::move(finding_);
}

void TopicMonitor::fail(std::int64_t at_ns, std::string values, std::optional<Span> needs) {
  ++finding_.failures;
  if (finding_.counterexamples.size() < Finding::kMostKept)
    finding_.counterexamples.push_back({at_ns, std::move(values), needs});
}

}  // namespace galilean::expect
