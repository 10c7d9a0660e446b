// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/verdict.h"

#include <algorithm>

#include "monitor/expect/judge/evaluate.h"

namespace galilean::expect {
namespace {

struct UnitOf {
  std::optional<Unit> operator()(const Always& claim) const { return margin_unit(claim.condition); }
  std::optional<Unit> operator()(const Never& claim) const {
    return claim.for_s ? unit::kSecond : margin_unit(claim.condition);
  }
  std::optional<Unit> operator()(const Eventually& claim) const {
    return claim.within_s ? unit::kSecond : margin_unit(claim.condition);
  }
  std::optional<Unit> operator()(const After&) const { return unit::kSecond; }
  std::optional<Unit> operator()(const Until& claim) const {
    return claim.within_s ? unit::kSecond : margin_unit(claim.condition);
  }
  std::optional<Unit> operator()(const AtEnd& claim) const { return margin_unit(claim.condition); }
  std::optional<Unit> operator()(const Count&) const { return unit::kNone; }
  std::optional<Unit> operator()(const Rate&) const { return unit::kHertz; }
  std::optional<Unit> operator()(const NoGaps&) const { return unit::kSecond; }
  std::optional<Unit> operator()(const Losses&) const { return unit::kNone; }
};

}  // namespace

std::size_t Judgement::count(Outcome outcome) const noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(
      verdicts, [&](const Verdict& verdict) { return verdict.finding.outcome == outcome; }));
}

std::optional<Unit> margin_unit(const Claim& claim) {
  return std::visit(UnitOf{}, claim.kind);
}

}  // namespace galilean::expect
