// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/condition_monitors.h"

#include <utility>

#include "monitor/expect/judge/monitor_words.h"

// Claims that something happens in time.

namespace galilean::expect {

std::int64_t EventuallyMonitor::deadline() const {
  if (met_ns_) return kNever_ns;
  if (since_ns_ && for_ns_ > 0) return *since_ns_ + for_ns_;
  return limited() && !told_ ? begin_ns() + within_ns_ + 1 : kNever_ns;
}

void EventuallyMonitor::step(std::int64_t at_ns, const Value& first, const Value&) {
  if (!limited() && (first.is_true() || first.is_false())) keep_most(first.margin);
  if (met_ns_) return;
  if (since_ns_ && at_ns - *since_ns_ >= for_ns_) met_ns_ = *since_ns_ + for_ns_;
  if (!first.is_true())
    since_ns_.reset();
  else if (!since_ns_)
    since_ns_ = at_ns;
  if (!met_ns_ && since_ns_ && for_ns_ == 0) met_ns_ = at_ns;
  const bool late = limited() && (met_ns_ ? *met_ns_ : at_ns) > begin_ns() + within_ns_;
  if (met_ns_ && limited()) set_margin(seconds(begin_ns() + within_ns_ - *met_ns_));
  if (!late || std::exchange(told_, true)) return;
  const std::int64_t deadline_ns = begin_ns() + within_ns_;
  fail(deadline_ns, Span{begin_ns(), deadline_ns});
}

void EventuallyMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  if (since_ns_ && !met_ns_ && end_ns - *since_ns_ >= for_ns_) {
    met_ns_ = *since_ns_ + for_ns_;
    if (limited()) set_margin(seconds(begin_ns() + within_ns_ - *met_ns_));
  }
  if (met_ns_ && !failed()) {
    finding.needs.reset();
    return;
  }
  if (failed() || told_) return;
  if (limited() && end_ns < begin_ns() + within_ns_)
    too_short(finding, begin_ns() + within_ns_ - end_ns);
  else if (!met_ns_)
    fail(end_ns, Span{begin_ns(), end_ns});
}

std::int64_t AfterMonitor::deadline() const {
  return pending_ns_.empty() ? kNever_ns : pending_ns_.front() + within_ns_ + 1;
}

void AfterMonitor::step(std::int64_t at_ns, const Value& first, const Value& second) {
  while (!pending_ns_.empty() && pending_ns_.front() + within_ns_ < at_ns) {
    const std::int64_t since_ns = pending_ns_.front();
    fail(since_ns + within_ns_, Span{since_ns, since_ns + within_ns_});
    if (!late_since_ns_) late_since_ns_ = since_ns;
    pending_ns_.pop_front();
  }
  if (first.is_true() && !was_true_) {
    ++triggers_;
    if (pending_ns_.size() < kMostPending) pending_ns_.push_back(at_ns);
  }
  was_true_ = first.is_true();
  if (!second.is_true()) return;
  const auto oldest = late_since_ns_        ? late_since_ns_
                      : pending_ns_.empty() ? std::nullopt
                                            : std::optional(pending_ns_.front());
  if (oldest) keep_least(seconds(within_ns_ - (at_ns - *oldest)));
  late_since_ns_.reset();
  pending_ns_.clear();
}

void AfterMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  if (late_since_ns_) keep_least(seconds(within_ns_ - (end_ns - *late_since_ns_)));
  finding.needs = Span{begin_ns(), end_ns};
  if (triggers_ == 0) finding.note = "what it begins with never happened";
  if (!pending_ns_.empty()) too_short(finding, pending_ns_.front() + within_ns_ - end_ns);
}

std::int64_t UntilMonitor::deadline() const {
  return limited() && !over_ ? begin_ns() + within_ns_ + 1 : kNever_ns;
}

void UntilMonitor::step(std::int64_t at_ns, const Value& first, const Value& second) {
  if (over_) return;
  const std::int64_t deadline_ns = limited() ? begin_ns() + within_ns_ : kNever_ns;
  if (at_ns > deadline_ns) {
    over_ = true;
    return fail(deadline_ns, Span{begin_ns(), deadline_ns});
  }
  if (second.is_true()) {
    over_ = true;
    met_ns_ = at_ns;
    if (limited()) set_margin(seconds(deadline_ns - at_ns));
    return;
  }
  if (!limited() && (first.is_true() || first.is_false())) keep_least(first.margin);
  if (!first.is_false()) return;
  over_ = true;
  fail(at_ns, Span{begin_ns(), at_ns});
}

void UntilMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  finding.needs = Span{begin_ns(), met_ns_.value_or(end_ns)};
  if (over_) return;
  if (limited()) return too_short(finding, begin_ns() + within_ns_ - end_ns);
  finding.note = "what it ends with never happened";
}

}  // namespace galilean::expect
