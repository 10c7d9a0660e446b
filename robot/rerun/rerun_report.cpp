// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/rerun_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/command_line/exit_code.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::robot {
namespace {

std::string rounded(double number, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

std::string as_json(const RerunReport& report, const RerunResult& result, double took_s) {
  nlohmann::ordered_json json{{"run", visible(report.title)},
                              {"robot", visible(result.robot)},
                              {"first_tick", result.first_tick},
                              {"ticks", result.ticks},
                              {"left_out", result.left_out},
                              {"recorded_s", result.recorded_s},
                              {"took_s", took_s},
                              {"same", exit_code(result) == 0},
                              {"divergence", nullptr},
                              {"cannot_tell", nullptr}};
  if (const auto& found = result.divergence)
    json["divergence"] = {{"tick", found->tick},
                          {"at_s", found->at_s},
                          {"cause", found->cause},
                          {"details", found->details}};
  if (!result.cannot_tell.empty())
    json["cannot_tell"] = {{"tick", result.untold_tick}, {"why", result.cannot_tell}};
  return ordered_json_text(json) + '\n';
}

std::string pace(const RerunResult& result, double took_s) {
  std::string text = rounded(result.recorded_s, 1) + " s run again in " + rounded(took_s, 2) + " s";
  if (took_s > 0) text += ", " + rounded(result.recorded_s / took_s, 0) + " x real time";
  return text;
}

std::string divergence_text(const RerunReport& report, const Divergence& found) {
  std::string text = "differs first in tick " + std::to_string(found.tick) + ", at " +
                     rounded(found.at_s, 3) + " s" +
                     (report.other_program ? " with the other program" : "") +
                     "\n  cause: " + found.cause + '\n';
  for (const auto& each : found.details) text += "  " + each + '\n';
  return text;
}

std::string untold_text(const RerunResult& result) {
  const std::string from =
      result.untold_tick == 0 ? "" : " from tick " + std::to_string(result.untold_tick);
  return "cannot tell" + from + ": " + result.cannot_tell + '\n';
}

}  // namespace

std::string describe(const RerunReport& report, const RerunResult& result, double took_s) {
  if (report.as_json) return as_json(report, result, took_s);
  std::string text = visible(report.title) + ": ";
  if (result.divergence) text += divergence_text(report, *result.divergence) + "  ";
  if (!result.cannot_tell.empty()) text += untold_text(result) + "  ";
  text += "0 bits differ in " + plural(result.ticks - (result.divergence ? 1 : 0), "tick");
  if (result.first_tick > 1) text += " from tick " + std::to_string(result.first_tick) + " on";
  if (result.left_out > 0) text += ", " + std::to_string(result.left_out) + " left out";
  return text + " (" + pace(result, took_s) + ")\n";
}

int exit_code(const RerunResult& result) noexcept {
  if (result.divergence) return kFailed;
  return result.cannot_tell.empty() && result.ticks > 0 ? 0 : kIncomplete;
}

}  // namespace galilean::robot
