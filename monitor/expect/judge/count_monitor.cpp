// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/plural.h"
#include "monitor/expect/judge/condition_monitors.h"
#include "monitor/expect/judge/duration_text.h"

namespace galilean::expect {

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
  most_ = std::max(most_, times_ns_.size());
  const double count = static_cast<double>(times_ns_.size());
  keep_least(limit_ - count);
  if (!holds(count, op_, limit_)) fail(at_ns);
  if (times_ns_.size() > kMostInWindow) times_ns_.pop_front();
}

void CountMonitor::conclude(std::int64_t end_ns, Finding& finding) {
  const Span all{begin_ns(), end_ns};
  const double count = static_cast<double>(count_);
  if (window_ns_ > 0) {
    finding.needs = all;
    finding.note =
        "it was so at most " + plural(most_, "time") + " in " + duration_text(window_ns_);
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
