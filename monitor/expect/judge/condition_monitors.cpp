// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/condition_monitors.h"

#include <utility>

#include "core/plural.h"
#include "monitor/expect/judge/duration_text.h"

namespace galilean::expect {
namespace {

double seconds(std::int64_t duration_ns) {
  return static_cast<double>(duration_ns) * 1e-9;
}

void cannot_tell(Finding& finding, std::string reason) {
  finding.outcome = Outcome::kCannotTell;
  finding.reason = std::move(reason);
}

/// Says that the recording ends before a deadline.
void too_short(Finding& finding, std::int64_t missing_ns) {
  cannot_tell(finding, "the recording ends " + duration_text(missing_ns) + " too early to tell");
}

}  // namespace

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

void CountMonitor::step(std::int64_t at_ns, const Value& first, const Value&) {
  const bool rose = first.is_true() && !was_true_;
  was_true_ = first.is_true();
  if (!rose) return;
  ++count_;
  newest_ns_ = at_ns;
  if (window_ns_ > 0) return slide(at_ns);
  const bool upper = op_ == Operator::kAtMost || op_ == Operator::kLess || op_ == Operator::kEqual;
  const double count = static_cast<double>(count_);
  if (upper && !failed() && (count > limit_ || (op_ == Operator::kLess && count >= limit_)))
    fail(at_ns);
}

void CountMonitor::slide(std::int64_t at_ns) {
  while (!times_ns_.empty() && times_ns_.front() < at_ns - window_ns_) times_ns_.pop_front();
  times_ns_.push_back(at_ns);
  const double count = static_cast<double>(times_ns_.size());
  keep_least(limit_ - count);
  if (!holds(count, op_, limit_)) fail(at_ns);
  if (count > limit_) times_ns_.pop_front();
}

void CountMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  const Span all{begin_ns(), end_ns};
  const double count = static_cast<double>(count_);
  if (window_ns_ > 0) {
    finding.needs = all;
    if (!finding.margin) finding.margin = limit_;
    return;
  }
  set_margin(margin(count, op_, limit_));
  finding.note = "it was so " + plural(count_, "time");
  if (!holds(count, op_, limit_)) {
    if (!failed()) fail(end_ns, all);
    return;
  }
  const bool enough = op_ == Operator::kAtLeast || op_ == Operator::kGreater;
  if (!enough) finding.needs = all;
}

}  // namespace galilean::expect
