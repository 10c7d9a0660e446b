// SPDX-License-Identifier: BSD-3-Clause
#include "core/json_text.h"
#include "monitor/expect/report/words.h"
#include "monitor/record/times.h"

namespace galilean::expect {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Counterexample& each, const Judgement& judgement) {
  return {{"time", monitor::iso_time(each.at_ns)},
          {"seconds", since_begin_s(each.at_ns, judgement)},
          {"values", each.values}};
}

Json json_of(const Verdict& verdict, const Report& report) {
  const auto& finding = verdict.finding;
  Json json{{"about", verdict.about},          {"robot", verdict.robot},
            {"expectation", verdict.text},     {"file", verdict.at.file},
            {"line", verdict.at.line},         {"column", verdict.at.column},
            {"outcome", word(finding.outcome)}};
  if (finding.margin)
    json["margin"] = {{"value", *finding.margin / verdict.unit.to_si},
                      {"unit", verdict.unit.symbol}};
  if (finding.outcome == Outcome::kCannotTell) json["reason"] = finding.reason;
  if (finding.outcome != Outcome::kCannotTell && !finding.note.empty()) json["note"] = finding.note;
  if (finding.outcome != Outcome::kFails) return json;
  json["failures"] = finding.failures;
  json["counterexamples"] = Json::array();
  for (const auto& each : finding.counterexamples)
    json["counterexamples"].push_back(json_of(each, report.judgement));
  if (!report.live) json["replay"] = replay_command(verdict, report);
  json["page"] = page_address(verdict);
  return json;
}

}  // namespace

std::string json_report(const Report& report) {
  const auto& judgement = report.judgement;
  Json json{{"recording", report.live ? Json() : Json(report.recording)},
            {"live", report.live},
            {"start", monitor::iso_time(judgement.begin_ns)},
            {"end", monitor::iso_time(judgement.end_ns)},
            {"holds", judgement.count(Outcome::kHolds)},
            {"fails", judgement.count(Outcome::kFails)},
            {"cannot_tell", judgement.count(Outcome::kCannotTell)},
            {"verdicts", Json::array()},
            {"problems", Json::array()},
            {"notes", Json::array()}};
  for (const auto& verdict : judgement.verdicts)
    json["verdicts"].push_back(json_of(verdict, report));
  for (const auto& problem : report.problems) json["problems"].push_back(problem.message);
  for (const auto& note : judgement.notes)
    if (!note.empty()) json["notes"].push_back(note);
  return ordered_json_text(json, 2) + "\n";
}

}  // namespace galilean::expect
