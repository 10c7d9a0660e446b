// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/collect.h"

#include <algorithm>
#include <utility>

#include "core/plural.h"

namespace galilean::expect {
namespace {

using Who = Scope::Who;

Verdict verdict_on(const Claim& claim, const std::string& about, const std::string& robot,
                   Finding finding) {
  const auto unit = margin_unit(claim);
  if (!unit) finding.margin.reset();
  if (finding.margin) *finding.margin += 0.0;  // people do not know -0
  return {about, robot, claim.text, claim.at, std::move(finding), unit.value_or(unit::kNone)};
}

Verdict nobody(const std::string& about, const std::string& text, const bhdl::Location& at) {
  Finding finding;
  finding.reason = "no robot was heard";
  return {about, {}, text, at, std::move(finding), {}};
}

int rank(Outcome outcome) {
  return outcome == Outcome::kHolds ? 2 : outcome == Outcome::kCannotTell ? 1 : 0;
}

/// Returns the verdict that decides for a robot of which all claims must hold: the worst.
Verdict worst(const Expectation& expectation, const std::string& robot, Finding* findings) {
  std::optional<Verdict> worst;
  for (const auto& claim : expectation.claims) {
    auto verdict = verdict_on(claim, "some robot", robot, std::move(*findings++));
    if (!worst || rank(verdict.finding.outcome) < rank(worst->finding.outcome))
      worst = std::move(verdict);
  }
  return std::move(*worst);
}

/// Returns whether the first is the better witness that some robot does as expected.
bool is_better(const Verdict& a, const Verdict& b) {
  const int rank_a = rank(a.finding.outcome), rank_b = rank(b.finding.outcome);
  if (rank_a != rank_b) return rank_a > rank_b;
  return a.text == b.text && a.finding.margin && b.finding.margin &&
         *a.finding.margin > *b.finding.margin;
}

/// Walks through the findings of each robot as the expectations come by.
class Collecting {
 public:
  explicit Collecting(Collected& collected) : collected_(collected) {}

  void add(const Expectation& expectation) {
    if (expectation.scope.who == Who::kSome) return add_some(expectation);
    bool any = false;
    const std::size_t first = verdicts_.size();
    for (auto& [name, robot] : collected_) {
      if (!concerns(expectation.scope, name)) continue;
      auto* findings = next(name, robot, expectation);
      if (!robot.heard && expectation.scope.who == Who::kEvery) continue;
      any = true;
      const std::string about = name.empty() ? "team" : name;
      for (const auto& claim : expectation.claims)
        verdicts_.push_back(verdict_on(claim, about, name, std::move(*findings++)));
    }
    if (!any)
      for (const auto& claim : expectation.claims)
        verdicts_.push_back(nobody("every robot", claim.text, claim.at));
    std::stable_sort(verdicts_.begin() + static_cast<std::ptrdiff_t>(first), verdicts_.end(),
                     [](const Verdict& a, const Verdict& b) {
                       return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
                     });
  }

  std::vector<Verdict> verdicts() && { return std::move(verdicts_); }

 private:
  void add_some(const Expectation& expectation) {
    std::optional<Verdict> best;
    std::size_t robots = 0;
    for (auto& [name, robot] : collected_) {
      if (!concerns(expectation.scope, name)) continue;
      auto* findings = next(name, robot, expectation);
      if (!robot.heard) continue;
      ++robots;
      auto verdict = worst(expectation, name, findings);
      if (!best || is_better(verdict, *best)) best = std::move(verdict);
    }
    if (!best) return verdicts_.push_back(nobody("some robot", expectation.text, expectation.at));
    auto& note = best->finding.note;
    const std::string of_it = note.empty() ? "" : ": " + note;
    if (best->finding.outcome == Outcome::kHolds) note = "it holds for " + best->robot + of_it;
    if (best->finding.outcome == Outcome::kFails)
      note = "it holds for none of " + plural(robots, "robot") + "; the nearest is " + best->robot +
             of_it;
    verdicts_.push_back(std::move(*best));
  }

  /// Returns the robot's findings on this expectation, and goes on behind them.
  Finding* next(const std::string& name, RobotFindings& robot, const Expectation& expectation) {
    std::size_t& at = taken_[name];
    Finding* first = robot.findings.data() + at;
    at += expectation.claims.size();
    return first;
  }

  Collected& collected_;
  std::map<std::string, std::size_t> taken_;
  std::vector<Verdict> verdicts_;
};

}  // namespace

bool concerns(const Scope& scope, const std::string& robot) {
  switch (scope.who) {
    case Who::kTeam:
      return robot.empty();
    case Who::kNamed:
      return robot == scope.robot;
    case Who::kEvery:
    case Who::kSome:
      break;
  }
  return !robot.empty();
}

std::vector<Verdict> collect(const std::vector<Expectation>& expectations, Collected& collected) {
  Collecting collecting(collected);
  for (const auto& expectation : expectations) collecting.add(expectation);
  return std::move(collecting).verdicts();
}

}  // namespace galilean::expect
