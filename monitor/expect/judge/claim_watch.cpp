// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/claim_watch.h"

#include <algorithm>

#include "monitor/expect/judge/evaluate.h"
#include "monitor/expect/judge/needs.h"

namespace galilean::expect {
namespace {

struct Conditions {
  const Condition* first = nullptr;
  const Condition* second = nullptr;
};

Conditions conditions_of(const Claim& claim) {
  Conditions found;
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.condition; }) found.first = &kind.condition;
        if constexpr (requires { kind.end; }) found.second = &kind.end;
        if constexpr (requires { kind.trigger; }) found = {&kind.trigger, &kind.response};
        if constexpr (requires { kind.what; }) found.first = std::get_if<Condition>(&kind.what);
      },
      claim.kind);
  return found;
}

}  // namespace

ClaimWatch::ClaimWatch(const Claim& claim, const Belief& belief)
    : belief_(belief), sources_(sources_of(claim)), monitor_(make_monitor(claim)) {
  const auto conditions = conditions_of(claim);
  first_ = conditions.first;
  second_ = conditions.second;
  monitor_->describe = [this] {
    std::string text = expect::describe(*first_, belief_, last_ns_);
    const auto more = second_ ? expect::describe(*second_, belief_, last_ns_) : std::string();
    if (more.empty() || text.find(more) != std::string::npos) return text;
    return text.empty() ? more : text + "; " + more;
  };
}

void ClaimWatch::advance(std::int64_t at_ns) {
  if (!begun_ || at_ns <= last_ns_) return;
  changes_.clear();
  add_changes(*first_, belief_, last_ns_, at_ns, changes_);
  if (second_) add_changes(*second_, belief_, last_ns_, at_ns, changes_);
  std::ranges::sort(changes_);
  auto change = changes_.begin();
  for (;;) {
    while (change != changes_.end() && *change <= last_ns_) ++change;
    std::int64_t next_ns = change == changes_.end() ? at_ns : *change;
    const std::int64_t deadline_ns = monitor_->deadline();
    if (deadline_ns > last_ns_) next_ns = std::min(next_ns, deadline_ns);
    if (next_ns >= at_ns) break;
    observe(next_ns);
  }
  if ((sources_ & kVariables) != 0) observe(at_ns);
}

void ClaimWatch::observe(std::int64_t at_ns) {
  begun_ = true;
  last_ns_ = at_ns;
  monitor_->observe(at_ns, evaluate(*first_, belief_, at_ns),
                    second_ ? evaluate(*second_, belief_, at_ns) : Value::of(true));
}

Finding ClaimWatch::finish(std::int64_t end_ns) {
  advance(end_ns);
  if (begun_) observe(std::max(end_ns, last_ns_));
  return monitor_->finish(std::max(end_ns, last_ns_));
}

}  // namespace galilean::expect
