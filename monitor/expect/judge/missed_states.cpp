// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/missed_states.h"

namespace galilean::expect {

void MissedStates::pass(std::uint64_t before, std::uint64_t number, const Span& when) {
  if (number <= before + 1) return;
  if (number - before - 1 > kMost - missed_.size()) return for_ever_.add(when);
  for (auto between = before + 1; between < number; ++between) missed_[between] = when;
}

bool MissedStates::find(std::uint64_t number) {
  return missed_.erase(number) > 0;
}

void MissedStates::restart() {
  for (const auto& [number, when] : missed_) for_ever_.add(when);
  missed_.clear();
}

SpanList MissedStates::times() const {
  SpanList all = for_ever_;
  for (const auto& [number, when] : missed_) all.add(when);
  return all;
}

}  // namespace galilean::expect
