// SPDX-License-Identifier: BSD-3-Clause
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/expect/problems/escapes.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

/// A text in JSON is one in YAML, too.
std::string line(const char* key, const std::string& text) {
  return text.empty() ? "" : std::string("  ") + key + ": " + json_text(text) + "\n";
}

}  // namespace

std::string tap_report(const Report& report) {
  const auto& verdicts = report.judgement.verdicts;
  std::string text =
      "TAP version 13\n1.." + std::to_string(verdicts.size() + report.problems.size()) + "\n";
  std::size_t number = 0;
  for (const auto& verdict : verdicts) {
    const bool holds = verdict.finding.outcome == Outcome::kHolds;
    text += (holds ? "ok " : "not ok ") + std::to_string(++number) + " - " +
            tap_description(title(verdict)) + "\n";
    text += "  ---\n" + line("outcome", word(verdict.finding.outcome)) +
            line("margin", margin_text(verdict)) +
            line(holds ? "note" : "message", explanation(verdict, report.judgement)) +
            line("at", place(verdict)) + line("see", how_to_see(verdict, report)) + "  ...\n";
  }
  for (const auto& problem : report.problems) text += tap_test(++number, problem);
  for (const auto& note : report.judgement.notes)
    if (!note.empty()) text += "# " + visible(note) + "\n";
  return text + "# " + totals(report.judgement) + "\n";
}

}  // namespace galilean::expect
