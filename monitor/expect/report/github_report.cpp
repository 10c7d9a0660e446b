// SPDX-License-Identifier: BSD-3-Clause
#include "core/visible_text.h"
#include "monitor/expect/problems/escapes.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

std::string annotation(const Verdict& verdict, const Report& report) {
  const bool fails = verdict.finding.outcome == Outcome::kFails;
  const std::string heading =
      fails ? "An expectation does not hold" : "An expectation cannot be told";
  std::string message = title(verdict) + "\n" + explanation(verdict, report.judgement);
  if (const auto margin = margin_text(verdict); !margin.empty()) message += "; " + margin;
  if (const auto see = how_to_see(verdict, report); !see.empty()) message += "\nto see it: " + see;
  return "::error file=" + command_text(visible(verdict.at.file), true) +
         ",line=" + std::to_string(verdict.at.line) + ",col=" + std::to_string(verdict.at.column) +
         ",title=" + command_text(heading, true) + "::" + command_text(message, false) + "\n";
}

}  // namespace

std::string github_report(const Report& report) {
  std::string text;
  for (const auto& verdict : report.judgement.verdicts)
    if (verdict.finding.outcome != Outcome::kHolds) text += annotation(verdict, report);
  text += github_problems(report.problems);
  for (const auto& note : report.judgement.notes)
    if (!note.empty()) text += "::warning::" + command_text(visible(note), false) + "\n";
  return text + "::notice::" + command_text(totals(report.judgement), false) + "\n";
}

}  // namespace galilean::expect
