// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/condition_monitors.h"
#include "monitor/expect/judge/monitor_words.h"

// Claims about how long, at all, and at the end.

namespace galilean::expect {

void AlwaysMonitor::step(std::int64_t at_ns, const Value& first, const Value&) {
  const Value value = wanted_ ? first : !first;
  const bool wrong = value.is_false();
  if (wrong && !was_wrong_) fail(at_ns);
  was_wrong_ = wrong;
  if (!wrong && !value.is_true()) return;
  had_value_ = true;
  keep_least(value.margin);
}

void AlwaysMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  finding.needs = Span{begin_ns(), end_ns};
  if (!had_value_) cannot_tell(finding, "what it asks about was never valid");
}

std::int64_t NeverForMonitor::deadline() const {
  return since_ns_ && !told_ ? *since_ns_ + for_ns_ : kNever_ns;
}

void NeverForMonitor::step(std::int64_t at_ns, const Value& first, const Value&) {
  if (since_ns_) measure(at_ns);
  if (first.is_true()) {
    if (!since_ns_) since_ns_ = at_ns;
  } else {
    since_ns_.reset();
    told_ = false;
  }
}

void NeverForMonitor::measure(std::int64_t at_ns) {
  const std::int64_t lasted_ns = at_ns - *since_ns_;
  keep_least(seconds(for_ns_ - lasted_ns));
  if (lasted_ns < for_ns_ || told_) return;
  told_ = true;
  fail(*since_ns_ + for_ns_, Span{*since_ns_, *since_ns_ + for_ns_});
}

void NeverForMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  if (since_ns_) measure(end_ns);
  if (!finding.margin) finding.margin = seconds(for_ns_);
  finding.needs = Span{begin_ns(), end_ns};
}

void AtEndMonitor::step(std::int64_t at_ns, const Value& first, const Value&) {
  newest_ns_ = at_ns;
  newest_ = first;
}

void AtEndMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  const Span since{newest_ns_, end_ns};
  finding.needs = since;
  if (newest_.is_true() || newest_.is_false()) set_margin(newest_.margin);
  if (newest_.is_false())
    fail(end_ns, since);
  else if (!newest_.is_true())
    cannot_tell(finding, newest_.is_missing() ? "it was not known at the end"
                                              : "what it asks about was invalid at the end");
}

}  // namespace galilean::expect
