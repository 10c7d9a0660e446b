// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/answer_words.h"

#include <algorithm>
#include <map>

namespace galilean::monitor::top {
namespace {

namespace statuses = msg::ProgramReply_Constants;
using Stage = PushReport::Stage;

/// Returns each robot's newest reply to the push.
std::map<std::string, const msg::ProgramReply*> newest_of(
    const std::string& id, const std::deque<msg::ProgramReply>& replies) {
  std::map<std::string, const msg::ProgramReply*> newest;
  for (const auto& reply : replies)
    if (!id.empty() && reply.id == id) newest[reply.robot] = &reply;
  return newest;
}

std::string objection_of(const msg::ProgramReply& reply) {
  const bool refused = reply.status == statuses::REJECTED;
  if (!refused && reply.status != statuses::ROLLED_BACK) return {};
  return reply.robot + (refused ? " refused it" : " went back") +
         (reply.message.empty() ? "" : ": " + reply.message);
}

std::string failure_of(const PushReport& report) {
  return report.title + (report.lines.empty() ? "" : ": " + report.lines[0].text);
}

}  // namespace

std::string answer_words(const PushReport& report, const std::deque<msg::ProgramReply>& replies) {
  const auto newest = newest_of(report.id, replies);
  std::string objections;
  for (const auto& [robot, reply] : newest)
    if (const auto words = objection_of(*reply); !words.empty())
      objections += (objections.empty() ? "" : "; ") + words;
  if (!objections.empty()) return objections;
  if (report.stage != Stage::kPushing && report.stage != Stage::kDone) return failure_of(report);
  if (newest.empty()) return "sent";
  const auto all_are = [&](std::uint8_t status) {
    return std::ranges::all_of(
        newest, [status](const auto& each) { return each.second->status >= status; });
  };
  return all_are(statuses::CONFIRMED) ? "taken"
         : all_are(statuses::RUNNING) ? "runs, on probation"
                                      : "is being built";
}

}  // namespace galilean::monitor::top
