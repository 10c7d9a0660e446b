// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/problems/escapes.h"
#include "monitor/expect/report/words.h"

namespace galilean::expect {
namespace {

std::string test_case(const Verdict& verdict, const Report& report) {
  const auto outcome = verdict.finding.outcome;
  std::string text = "    <testcase" + xml_attribute("classname", verdict.about) +
                     xml_attribute("name", title(verdict)) +
                     xml_attribute("file", verdict.at.file) +
                     xml_attribute("line", std::to_string(verdict.at.line));
  if (outcome == Outcome::kHolds) return text + "/>\n";
  const bool fails = outcome == Outcome::kFails;
  const char* element = fails ? "failure" : "error";
  const auto why = explanation(verdict, report.judgement);
  text += std::string(">\n      <") + element +
          xml_attribute("message", fails ? why : "cannot tell: " + why) +
          xml_attribute("type", word(outcome)) + ">" + xml_text(place(verdict));
  if (const auto margin = margin_text(verdict); !margin.empty()) text += "\n" + xml_text(margin);
  if (const auto see = how_to_see(verdict, report); !see.empty())
    text += "\nto see it: " + xml_text(see);
  return text + "</" + element + ">\n    </testcase>\n";
}

}  // namespace

std::string junit_report(const Report& report) {
  const auto& judgement = report.judgement;
  const std::string counts =
      xml_attribute("tests", std::to_string(judgement.verdicts.size() + report.problems.size())) +
      xml_attribute("failures", std::to_string(judgement.count(Outcome::kFails))) +
      xml_attribute("errors",
                    std::to_string(judgement.count(Outcome::kCannotTell) + report.problems.size()));
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                     ">\n  <testsuite" + xml_attribute("name", report.recording) + counts + ">\n";
  for (const auto& verdict : judgement.verdicts) text += test_case(verdict, report);
  for (const auto& problem : report.problems) text += junit_case(report.recording, problem);
  std::string notes;
  for (const auto& note : judgement.notes)
    if (!note.empty()) notes += xml_text(note) + "\n";
  if (!notes.empty()) text += "    <system-out>" + notes + "</system-out>\n";
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace galilean::expect
