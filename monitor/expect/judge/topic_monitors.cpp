// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/topic_monitors.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>

#include "core/plural.h"
#include "monitor/expect/judge/duration_text.h"
#include "monitor/expect/judge/monitor.h"

namespace galilean::expect {
namespace {

bool has_upper_limit(Operator op) {
  return op == Operator::kAtMost || op == Operator::kLess || op == Operator::kEqual;
}

/// Says which outcomes need that no message is missing: more messages could come only to the good
/// of a lower limit.
void judge_number(double number, Operator op, double limit, const Span& all,
                  const std::string& values, Finding& finding,
                  const std::function<void(std::optional<Span>)>& fail) {
  finding.margin = margin(number, op, limit);
  finding.note = values;
  const bool lower = op == Operator::kAtLeast || op == Operator::kGreater;
  if (holds(number, op, limit))
    finding.needs = lower ? std::nullopt : std::optional(all);
  else
    fail(has_upper_limit(op) && number > limit ? std::nullopt : std::optional(all));
}

/// Returns whether a comparison comes out differently for numbers from one to another.
bool differs_within(double from, double to, Operator op, double limit) {
  if (from == to) return false;
  const bool of_one_number = op == Operator::kEqual || op == Operator::kUnequal;
  if (of_one_number) return from <= limit && limit <= to;
  return holds(from, op, limit) != holds(to, op, limit);
}

class MessageCount final : public TopicMonitor {
 public:
  MessageCount(Operator op, double limit, std::optional<double> window_s)
      : op_(op), limit_(limit), window_ns_(window_s ? to_ns(*window_s) : 0) {}

 private:
  void step(std::int64_t at_ns) override {
    if (window_ns_ == 0) return;
    while (!times_ns_.empty() && times_ns_.front() < at_ns - window_ns_) times_ns_.pop_front();
    times_ns_.push_back(at_ns);
    most_ = std::max(most_, times_ns_.size());
    const auto count = static_cast<double>(times_ns_.size());
    finding_.margin = std::min(finding_.margin.value_or(limit_), limit_ - count);
    if (!holds(count, op_, limit_)) fail(at_ns, plural(times_ns_.size(), "message"));
    if (times_ns_.size() > kMostInWindow) times_ns_.pop_front();
  }
  void conclude(std::int64_t end_ns, Finding& finding) override {
    const Span all{first_ns_, end_ns};
    if (window_ns_ > 0) {
      finding.needs = all;
      finding.note = "at most " + plural(most_, "message") + " in " + duration_text(window_ns_);
      return doubt_times();
    }
    const auto number = static_cast<double>(count_);
    const std::string values = plural(count_, "message");
    if (differs_within(number, number + static_cast<double>(missing()), op_, limit_))
      return cannot_tell(values + " came, and " + missing_text());
    judge_number(number, op_, limit_, all, values, finding,
                 [&](auto needs) { fail(end_ns, values, needs); });
  }

  Operator op_;
  double limit_;
  std::int64_t window_ns_;
  std::deque<std::int64_t> times_ns_;  ///< those in the window, at most kMostInWindow + 1
  std::size_t most_ = 0;               ///< in any window
};

/// The messages after the first, a second of the time from the first to the end.
class RateMonitor final : public TopicMonitor {
 public:
  RateMonitor(Operator op, double limit_hz) : op_(op), limit_hz_(limit_hz) {}

 private:
  void step(std::int64_t) override {}
  void conclude(std::int64_t end_ns, Finding& finding) override {
    if (end_ns <= first_ns_) {
      cannot_tell("the recording ends with its first message");
      return;
    }
    const double span_s = static_cast<double>(end_ns - first_ns_) * 1e-9;
    const double rate_hz = static_cast<double>(count_ - 1) / span_s;
    const std::string values = "rate is " + short_number(rate_hz) + " Hz";
    const double most_hz = static_cast<double>(count_ - 1 + missing()) / span_s;
    if (differs_within(rate_hz, most_hz, op_, limit_hz_))
      return cannot_tell(values + ", and " + missing_text());
    judge_number(rate_hz, op_, limit_hz_, {first_ns_, end_ns}, values, finding,
                 [&](auto needs) { fail(end_ns, values, needs); });
  }

  Operator op_;
  double limit_hz_;
};

class GapMonitor final : public TopicMonitor {
 public:
  explicit GapMonitor(double longest_s) : longest_ns_(to_ns(longest_s)) {}

 private:
  void step(std::int64_t at_ns) override {
    if (count_ > 1) measure(at_ns);
  }
  void measure(std::int64_t at_ns) {
    const std::int64_t gap_ns = at_ns - newest_ns_;
    const double left_s = static_cast<double>(longest_ns_ - gap_ns) * 1e-9;
    finding_.margin = std::min(finding_.margin.value_or(left_s), left_s);
    if (gap_ns > longest_ns_)
      fail(newest_ns_, "nothing came for " + duration_text(gap_ns), Span{newest_ns_, at_ns});
  }
  void conclude(std::int64_t end_ns, Finding&) override {
    measure(end_ns);
    doubt_times();
  }

  std::int64_t longest_ns_;
};

/// The messages that are missing, by their numbers and by what the recorder counted.
class LossMonitor final : public TopicMonitor {
 public:
  LossMonitor(Operator op, double limit) : op_(op), limit_(limit) {}

 private:
  void step(std::int64_t at_ns) override {
    const auto lost = gaps().missing();
    const auto number = static_cast<double>(lost);
    if (passed_ || !has_upper_limit(op_) || number < limit_ || holds(number, op_, limit_)) return;
    passed_ = Counterexample{at_ns, plural(lost, "message") + " lost by then", std::nullopt};
  }
  void conclude(std::int64_t end_ns, Finding& finding) override {
    if (auto reason = doubt(); !reason.empty()) return cannot_tell(std::move(reason));
    const std::string values = plural(missing(), "message") + " lost";
    judge_number(static_cast<double>(missing()), op_, limit_, {first_ns_, end_ns}, values, finding,
                 [&](auto needs) {
                   if (passed_ && !needs)
                     fail(passed_->at_ns, passed_->values);
                   else
                     fail(end_ns, values, needs);
                 });
  }

  Operator op_;
  double limit_;
  std::optional<Counterexample> passed_;  ///< when the limit was passed
};

}  // namespace

std::unique_ptr<TopicMonitor> make_topic_monitor(const Claim& claim) {
  const auto& kind = claim.kind;
  if (const auto* rate = std::get_if<Rate>(&kind))
    return std::make_unique<RateMonitor>(rate->op, rate->limit_hz);
  if (const auto* gaps = std::get_if<NoGaps>(&kind))
    return std::make_unique<GapMonitor>(gaps->longest_s);
  if (const auto* losses = std::get_if<Losses>(&kind))
    return std::make_unique<LossMonitor>(losses->op, losses->limit);
  const auto* count = std::get_if<Count>(&kind);
  if (count && std::holds_alternative<TopicName>(count->what))
    return std::make_unique<MessageCount>(count->op, count->limit, count->window_s);
  return nullptr;
}

const TopicName* topic_of(const Claim& claim) {
  const auto& kind = claim.kind;
  if (const auto* rate = std::get_if<Rate>(&kind)) return &rate->topic;
  if (const auto* gaps = std::get_if<NoGaps>(&kind)) return &gaps->topic;
  if (const auto* losses = std::get_if<Losses>(&kind)) return &losses->topic;
  const auto* count = std::get_if<Count>(&kind);
  return count ? std::get_if<TopicName>(&count->what) : nullptr;
}

}  // namespace galilean::expect
