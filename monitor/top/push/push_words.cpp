// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/push/push_words.h"

#include "core/plural.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor::top {
namespace {

using nlohmann::json;
using Stage = PushReport::Stage;
using Lines = std::vector<Sheet::Line>;

void add_diagnostics(const json& answer, Lines& lines) {
  const bool has_them = answer.is_object() && answer.contains("diagnostics");
  for (const auto& diagnostic : has_them ? answer["diagnostics"] : json::array()) {
    const auto severity = diagnostic.value("severity", "");
    const std::string place = diagnostic.value("file", "") + ":" +
                              std::to_string(diagnostic.value("line", 0)) + ":" +
                              std::to_string(diagnostic.value("column", 0));
    lines.push_back({place + ": " + severity + ": " + diagnostic.value("message", ""),
                     severity == "error" ? Style::kAlarm : Style::kWarning});
    if (const auto hint = diagnostic.value("hint", ""); !hint.empty())
      lines.push_back({"  hint: " + hint, Style::kDim});
  }
}

void add_changes(const json& answer, Lines& lines) {
  if (!answer.contains("changes")) return;
  const auto& changes = answer["changes"];
  lines.push_back({changes.empty() ? std::string("It does the same as what runs now.")
                                   : plural(changes.size(), "difference") + " from what runs now:",
                   Style::kBold});
  for (const auto& change : changes) {
    const auto words = change.get<std::string>();
    const Style style = words.starts_with('+')   ? Style::kGood
                        : words.starts_with('-') ? Style::kAlarm
                                                 : Style::kPlain;
    lines.push_back({"  " + words, style});
  }
}

Style style_of(const std::optional<StepState>& state) {
  if (state == StepState::kDone) return Style::kGood;
  if (state == StepState::kFailed) return Style::kAlarm;
  return state == StepState::kRunning ? Style::kBold : Style::kDim;
}

bool is_done(const std::optional<PushState>& state) {
  return state == PushState::kDone || state == PushState::kToldLater;
}

void add_reply(const json& reply, Lines& lines) {
  const auto word = reply.value("status", "");
  const auto status = reply_status_of(word);
  const bool bad = status == ReplyStatus::kRejected || status == ReplyStatus::kRolledBack ||
                   status == ReplyStatus::kNoAnswer;
  const auto message = reply.value("message", "");
  lines.push_back(
      {"  " + reply.value("robot", "") + "  " + word + (message.empty() ? "" : "  " + message),
       bad ? Style::kAlarm : Style::kPlain});
}

}  // namespace

PushReport report_of_check(const json& answer, const std::string& file) {
  const bool ok = answer.value("ok", false);
  PushReport report{ok ? Stage::kReady : Stage::kRefused,
                    ok ? "Push " + file + " " + answer.value("hash", "").substr(0, 8)
                       : "Nothing was pushed: " + file + " has errors",
                    {}};
  add_diagnostics(answer, report.lines);
  if (ok) add_changes(answer, report.lines);
  return report;
}

PushReport report_of_push(const json& answer) {
  const auto state = push_state_of(answer.value("state", ""));
  const std::string program =
      answer.value("program", "") + " " + answer.value("hash", "").substr(0, 8);
  PushReport report;
  report.stage = state == PushState::kRunning ? Stage::kPushing
                 : is_done(state)             ? Stage::kDone
                                              : Stage::kFailed;
  report.title = "Push of " + program + ": " + answer.value("state", "");
  report.id = answer.value("id", "");
  for (const auto& step : answer.value("steps", json::array())) {
    const auto step_state = step_state_of(step.value("state", ""));
    if (step_state == StepState::kLeftOut) continue;
    report.lines.push_back(
        {step.value("name", "") + "  " + step.value("state", "") + "  " + step.value("detail", ""),
         style_of(step_state)});
  }
  for (const auto& reply : answer.value("replies", json::array())) add_reply(reply, report.lines);
  if (state == PushState::kInterrupted)
    report.lines.push_back(
        {"Its monitor ended before it did: some robots may not have got it.", Style::kWarning});
  if (const auto why = answer.value("not_kept", ""); !why.empty())
    report.lines.push_back({"The history does not hold all of this yet: " + why, Style::kAlarm});
  return report;
}

PushReport report_of_refusal(const json& answer, const std::string& why) {
  PushReport report{Stage::kRefused, "Nothing was pushed", {{why, Style::kAlarm}}};
  add_diagnostics(answer, report.lines);
  return report;
}

std::vector<PastPush> past_pushes(const json& answer) {
  std::vector<PastPush> pushes;
  for (const auto& each : answer.value("pushes", json::array())) {
    PastPush push{.pushed_ns = each.value("pushed_ns", std::int64_t{}),
                  .author = each.value("author", ""),
                  .program = each.value("program", ""),
                  .hash = each.value("hash", ""),
                  .state = each.value("state", ""),
                  .targets = each.value("targets", std::vector<std::string>{})};
    const auto state = push_state_of(push.state);
    push.has_failed = state != PushState::kRunning && !is_done(state);
    for (const auto& reply : each.value("replies", json::array()))
      push.outcomes.push_back(reply.value("robot", "") + " " + reply.value("status", ""));
    pushes.push_back(std::move(push));
  }
  return pushes;
}

PushReport report_of_silence(const PushReport& before, const std::string& why) {
  PushReport report{
      Stage::kUnknown,
      "The monitor stopped answering",
      {{"Whether the program was pushed is not known.", Style::kAlarm}, {why, Style::kDim}}};
  report.lines.insert(report.lines.end(), before.lines.begin(), before.lines.end());
  return report;
}

}  // namespace galilean::monitor::top
