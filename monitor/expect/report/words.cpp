// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/report/words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/expect/judge/duration_text.h"
#include "monitor/record/times.h"

namespace galilean::expect {
namespace {

/// A viewer needs a moment to see what led to it.
constexpr double kBefore_s = 2;

const Counterexample* first_of(const Verdict& verdict) {
  const bool fails = verdict.finding.outcome == Outcome::kFails;
  return fails && !verdict.finding.counterexamples.empty()
             ? &verdict.finding.counterexamples.front()
             : nullptr;
}

std::string fixed(double number, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

/// Returns the text as one word of a shell's command.
std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("/._-+:,@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Returns the text as a value in an address. Names of robots hold what the wire brought.
std::string in_query(const std::string& text) {
  std::string safe;
  for (const unsigned char c : text) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", c);
    const bool plain = std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    safe += plain ? std::string(1, static_cast<char>(c)) : code;
  }
  return safe;
}

}  // namespace

std::string title(const Verdict& verdict) {
  const bool whole = verdict.text.starts_with(verdict.about);
  return visible(whole ? verdict.text : verdict.about + ": " + verdict.text);
}

std::string place(const Verdict& verdict) {
  return visible(verdict.at.file) + ":" + std::to_string(verdict.at.line) + ":" +
         std::to_string(verdict.at.column);
}

std::string word(Outcome outcome) {
  return outcome == Outcome::kHolds   ? "holds"
         : outcome == Outcome::kFails ? "fails"
                                      : "cannot tell";
}

std::string margin_text(const Verdict& verdict) {
  const auto& finding = verdict.finding;
  if (!finding.margin || finding.outcome == Outcome::kCannotTell) return {};
  const double margin = *finding.margin / verdict.unit.to_si;
  const std::string unit =
      verdict.unit.symbol.empty() ? "" : " " + std::string(verdict.unit.symbol);
  if (finding.outcome == Outcome::kHolds && margin >= 0)
    return short_number(margin) + unit + " to spare";
  if (finding.outcome == Outcome::kFails && margin <= 0)
    return "missed by " + short_number(std::abs(margin)) + unit;
  return {};
}

double since_begin_s(std::int64_t at_ns, const Judgement& judgement) {
  std::int64_t since_ns = at_ns - judgement.begin_ns;
  for (const auto& silence : judgement.silences)
    if (silence.from_ns < at_ns) since_ns -= std::min(at_ns, silence.to_ns) - silence.from_ns;
  return std::max(0.0, static_cast<double>(since_ns) * 1e-9);
}

std::string explanation(const Verdict& verdict, const Judgement& judgement) {
  const auto& finding = verdict.finding;
  if (finding.outcome == Outcome::kCannotTell) return visible(finding.reason);
  const auto* first = first_of(verdict);
  if (!first) return visible(finding.note);
  std::string text = "at " + fixed(since_begin_s(first->at_ns, judgement), 3) + " s (" +
                     monitor::iso_time(first->at_ns) + ")";
  if (!first->values.empty()) text += ": " + visible(first->values);
  if (finding.failures > 1) text += "; " + std::to_string(finding.failures) + " times in all";
  const bool is_new = finding.note != first->values;  // a rate is both
  if (!finding.note.empty() && is_new) text += "; " + visible(finding.note);
  return text;
}

std::string replay_command(const Verdict& verdict, const Report& report) {
  const auto* first = first_of(verdict);
  if (!first || report.live) return {};
  const double from_s = std::max(0.0, since_begin_s(first->at_ns, report.judgement) - kBefore_s);
  return "galilean replay " + shell_word(report.recording) + " --from " + fixed(from_s, 3);
}

std::string page_address(const Verdict& verdict) {
  const auto* first = first_of(verdict);
  if (!first) return {};
  const std::string robot = verdict.robot.empty() ? "" : "robot=" + in_query(verdict.robot) + "&";
  return "/?" + robot + "at=" + monitor::iso_time(static_cast<std::uint64_t>(first->at_ns));
}

std::string how_to_see(const Verdict& verdict, const Report& report) {
  const auto address = page_address(verdict);
  if (address.empty()) return {};
  const auto replay = replay_command(verdict, report);
  return visible((replay.empty() ? "" : replay + ", and ") + "on the monitor's page: " + address);
}

std::string totals(const Judgement& judgement) {
  const auto holds = judgement.count(Outcome::kHolds), fails = judgement.count(Outcome::kFails);
  const auto unknown = judgement.count(Outcome::kCannotTell);
  std::string text = std::to_string(holds) + agreeing(holds, " holds", " hold");
  if (fails > 0)
    text += ", " + std::to_string(fails) + agreeing(fails, " does", " do") + " not hold";
  if (unknown > 0) text += ", " + std::to_string(unknown) + " cannot be told";
  return text;
}

}  // namespace galilean::expect
