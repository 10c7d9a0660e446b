// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/monitor.h"

#include <cmath>
#include <utility>

#include "monitor/expect/judge/condition_monitors.h"
#include "monitor/expect/judge/duration_text.h"

namespace galilean::expect {

void Monitor::observe(std::int64_t at_ns, const Value& first, const Value& second) {
  const bool missing = first.is_missing() || second.is_missing();
  if (!begun_) {
    if (missing) return;
    begun_ = true;
    begin_ns_ = at_ns;
  }
  if (was_missing_) missing_.add({last_ns_, at_ns});
  was_missing_ = missing;
  last_ns_ = at_ns;
  step(at_ns, first, second);
}

Finding Monitor::finish(std::int64_t end_ns) {
  if (!begun_) {
    finding_.reason = "what it asks about was never heard";
    return std::move(finding_);
  }
  if (was_missing_) missing_.add({last_ns_, end_ns});
  finding_.outcome = Outcome::kHolds;
  conclude(end_ns, finding_);
  if (failed()) {
    finding_.outcome = Outcome::kFails;
    finding_.reason.clear();
  } else if (finding_.outcome == Outcome::kHolds && finding_.needs) {
    if (const auto gap = missing_.overlap(*finding_.needs)) {
      finding_.outcome = Outcome::kCannotTell;
      finding_.reason = "nothing was heard of it for " + duration_text(gap->to_ns - gap->from_ns);
    }
  }
  if (finding_.outcome == Outcome::kHolds && doubtful_ > 0) {
    finding_.outcome = Outcome::kCannotTell;
    finding_.reason = "it seems not to hold, but messages are missing there";
  }
  if (finding_.margin && !std::isfinite(*finding_.margin)) finding_.margin.reset();
  lift_limits({begin_ns_, end_ns}, finding_);
  return std::move(finding_);
}

void Monitor::fail(std::int64_t at_ns, std::optional<Span> needs) {
  if (needs && (missing_.overlap(*needs) || (was_missing_ && last_ns_ <= needs->to_ns))) {
    ++doubtful_;
    return;
  }
  ++finding_.failures;
  const bool kept = finding_.counterexamples.size() < Finding::kMostKept;
  if (!kept && !on_failure) return;
  std::string values = describe ? describe() : std::string();
  if (on_failure) on_failure(at_ns, values);
  if (kept) finding_.counterexamples.push_back({at_ns, std::move(values), needs});
}

void Monitor::keep_least(double margin) noexcept {
  if (!finding_.margin || margin < *finding_.margin) finding_.margin = margin;
}

void Monitor::keep_most(double margin) noexcept {
  if (!finding_.margin || margin > *finding_.margin) finding_.margin = margin;
}

std::unique_ptr<Monitor> make_monitor(const Claim& claim) {
  const auto& kind = claim.kind;
  if (std::holds_alternative<Always>(kind)) return std::make_unique<AlwaysMonitor>(true);
  if (const auto* never = std::get_if<Never>(&kind)) {
    if (never->for_s) return std::make_unique<NeverForMonitor>(*never->for_s);
    return std::make_unique<AlwaysMonitor>(false);
  }
  if (const auto* eventually = std::get_if<Eventually>(&kind))
    return std::make_unique<EventuallyMonitor>(eventually->within_s, eventually->for_s);
  if (const auto* after = std::get_if<After>(&kind))
    return std::make_unique<AfterMonitor>(after->within_s);
  if (const auto* until = std::get_if<Until>(&kind))
    return std::make_unique<UntilMonitor>(until->within_s);
  if (std::holds_alternative<AtEnd>(kind)) return std::make_unique<AtEndMonitor>();
  const auto* count = std::get_if<Count>(&kind);
  if (count && std::holds_alternative<Condition>(count->what))
    return std::make_unique<CountMonitor>(count->op, count->limit, count->window_s);
  return nullptr;
}

}  // namespace galilean::expect
