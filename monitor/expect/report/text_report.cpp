// SPDX-License-Identifier: BSD-3-Clause
#include "core/visible_text.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

constexpr const char* kIndent = "       ";

std::string label(Outcome outcome) {
  return outcome == Outcome::kHolds   ? "ok     "
         : outcome == Outcome::kFails ? "FAILS  "
                                      : "?      ";
}

}  // namespace

std::string text_report(const Report& report) {
  std::string text;
  for (const auto& verdict : report.judgement.verdicts) {
    const bool holds = verdict.finding.outcome == Outcome::kHolds;
    const auto margin = margin_text(verdict), why = explanation(verdict, report.judgement);
    const auto see = how_to_see(verdict, report);
    text += label(verdict.finding.outcome) + title(verdict);
    if (!margin.empty()) text += " (" + margin + ")";
    if (holds && !why.empty()) text += "; " + why;
    text += '\n';
    if (holds) continue;
    if (verdict.finding.outcome == Outcome::kCannotTell)
      text += kIndent + ("cannot tell: " + why) + '\n';
    else
      text += kIndent + why + '\n';
    text += kIndent + ("expected at " + place(verdict)) + '\n';
    if (!see.empty()) text += kIndent + ("to see it: " + see) + '\n';
  }
  for (const auto& problem : report.problems)
    text += "ERROR  " + problem.name + ": " + visible(problem.message) + '\n';
  for (const auto& note : report.judgement.notes)
    if (!note.empty()) text += "note:  " + visible(note) + '\n';
  return text + totals(report.judgement) + '\n';
}

}  // namespace galilean::expect
