// SPDX-License-Identifier: BSD-3-Clause
#include "core/visible_text.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

/// Returns the text as it may stand within an attribute or an element.
std::string xml_text(const std::string& text) {
  std::string safe;
  for (const char c : visible(text)) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml_text(value) + "\"";
}

std::string test_case(const Verdict& verdict, const Report& report) {
  const auto outcome = verdict.finding.outcome;
  std::string text = "    <testcase" + attribute("classname", verdict.about) +
                     attribute("name", title(verdict)) + attribute("file", verdict.at.file) +
                     attribute("line", std::to_string(verdict.at.line));
  if (outcome == Outcome::kHolds) return text + "/>\n";
  const bool fails = outcome == Outcome::kFails;
  const char* element = fails ? "failure" : "error";
  const auto why = explanation(verdict, report.judgement);
  text += std::string(">\n      <") + element +
          attribute("message", fails ? why : "cannot tell: " + why) +
          attribute("type", word(outcome)) + ">" + xml_text(place(verdict));
  if (const auto margin = margin_text(verdict); !margin.empty()) text += "\n" + xml_text(margin);
  if (const auto see = how_to_see(verdict, report); !see.empty())
    text += "\nto see it: " + xml_text(see);
  return text + "</" + element + ">\n    </testcase>\n";
}

}  // namespace

std::string junit_report(const Report& report) {
  const auto& judgement = report.judgement;
  const std::string counts =
      attribute("tests", std::to_string(judgement.verdicts.size())) +
      attribute("failures", std::to_string(judgement.count(Outcome::kFails))) +
      attribute("errors", std::to_string(judgement.count(Outcome::kCannotTell)));
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                     ">\n  <testsuite" + attribute("name", report.recording) + counts + ">\n";
  for (const auto& verdict : judgement.verdicts) text += test_case(verdict, report);
  std::string notes;
  for (const auto& note : judgement.notes)
    if (!note.empty()) notes += xml_text(note) + "\n";
  if (!notes.empty()) text += "    <system-out>" + notes + "</system-out>\n";
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace galilean::expect
