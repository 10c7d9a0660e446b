// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/alarms.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/cut_text.h"
#include "monitor/team/break_reason.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kLateShown = std::chrono::seconds(20);
constexpr Duration kStuckAfter = std::chrono::seconds(20);
/// Less than this is noise of standing.
constexpr double kMoved_m = 0.03, kTurned_rad = 0.1;
/// A robot known no better than this, at two standard deviations, is drawn where it may not be.
constexpr double kUncertain_m = 0.8;

/// Returns the longer half axis of the ellipse of two standard deviations.
double uncertainty_m(const msg::MapRobot& robot) {
  const double middle = (robot.variance_xx + robot.variance_yy) / 2;
  const double half = (robot.variance_xx - robot.variance_yy) / 2;
  return 2 * std::sqrt(std::max(0.0, middle + std::hypot(half, robot.variance_xy)));
}

void find_misplaced(const DashboardModel& model, std::vector<Alarm>& alarms) {
  const auto* map = model.objects();
  if (!map) return;
  for (const auto& robot : map->robots) {
    const double radius_m = uncertainty_m(robot);
    if (robot.silent || !(radius_m >= kUncertain_m)) continue;
    char text[64];
    std::snprintf(text, sizeof text, " may be %.1f m from where the map shows it", radius_m);
    alarms.push_back(
        {"uncertain " + robot.name, AlarmKind::kUncertain, robot.name, robot.name + text});
  }
}

void find_failed_pushes(const DashboardModel& model, std::vector<Alarm>& alarms) {
  namespace statuses = msg::ProgramReply_Constants;
  for (const auto& reply : model.replies()) {
    const bool refused = reply.status == statuses::REJECTED;
    if (!refused && reply.status != statuses::ROLLED_BACK) continue;
    const std::string name = model.pushed_name(reply.id);
    std::string words = reply.robot + (refused ? " refused " : " went back from ") +
                        (name.empty() ? std::string(cut_text(reply.hash, 8)) : name);
    if (!reply.message.empty()) words += ": " + reply.message;
    alarms.push_back(
        {"push " + reply.id + " " + reply.robot, AlarmKind::kPush, reply.robot, std::move(words)});
  }
}

/// Whoever steers must know at once what is wrong with the monitor itself.
void add_monitors_problem(const char* key, std::string words, std::vector<Alarm>& alarms) {
  if (words.empty()) return;
  if (words.ends_with('.')) words.pop_back();
  alarms.push_back({key, AlarmKind::kProblem, "monitor", std::move(words)});
}

}  // namespace

void AlarmFinder::remember(Memory& memory, const msg::RobotState& state, Time now) const {
  if (state.overruns > memory.overruns && memory.stands_at) memory.late = now;
  memory.overruns = state.overruns;
  const Pose2 pose{{state.x_m, state.y_m}, state.heading_rad};
  const bool stands =
      memory.stands_at && !state.held &&
      (memory.stands_at->position_m - pose.position_m).norm() < kMoved_m &&
      std::abs(wrap_angle(memory.stands_at->heading_rad - pose.heading_rad)) < kTurned_rad;
  if (stands) return;
  memory.stands_at = pose;
  memory.stands_since = now;
}

void AlarmFinder::find_of(const Robot& robot, const DashboardModel& model, Time now,
                          std::vector<Alarm>& alarms) {
  const std::string& name = robot.name;
  const auto add = [&](AlarmKind kind, const char* word, std::string words) {
    alarms.push_back({word + (" " + name), kind, name, std::move(words)});
  };
  const bool replayed = model.team().replayed(robot);
  if (replayed && model.team().silent(robot)) return;  // the recording has ended
  if (model.team().silent(robot))
    return alarms.push_back({"silent " + name, AlarmKind::kSilent, name, name + " is silent",
                             name + " was silent", robot.heard});
  if (!robot.state || robot.state->out_of_service) return;
  const auto& state = *robot.state;
  const Memory& memory = memories_[name];
  if (memory.late && now - *memory.late <= kLateShown)
    add(AlarmKind::kLate, "late",
        name + "'s ticks begin late (" + std::to_string(state.overruns) + " so far)");
  const bool waits = (robot.program && robot.program->start_state == state.state) ||
                     (robot.breaks && waits_at_lock(*robot.breaks));
  if (!state.held && !waits && now - memory.stands_since >= kStuckAfter)
    add(AlarmKind::kStuck, "stuck", name + " does not move in " + state.state);
  if (!replayed && state.program_hash != team_hash_)
    add(AlarmKind::kDrift, "drift",
        name + " runs " + state.program_name + ", another program than the team");
  for (const auto& problem : state.problems)
    alarms.push_back(
        {"problem " + name + " " + problem, AlarmKind::kProblem, name, name + ": " + problem});
}

std::vector<Alarm> AlarmFinder::find(const DashboardModel& model, Time now) {
  std::vector<Alarm> alarms;
  team_hash_ = model.team().program_hash();
  std::erase_if(memories_, [&](const auto& each) { return !model.team().find(each.first); });
  for (const auto& [name, robot] : model.team().robots()) {
    if (robot.state) remember(memories_[name], *robot.state, now);
    find_of(robot, model, now, alarms);
  }
  find_misplaced(model, alarms);
  find_failed_pushes(model, alarms);
  add_monitors_problem("history", model.history_problem(), alarms);
  add_monitors_problem("map", model.map_problem(), alarms);
  for (const auto& each : model.refusals().ongoing(now))
    alarms.push_back(
        {each.key, each.is_loss ? AlarmKind::kLost : AlarmKind::kRefused, each.sender, each.words});
  return alarms;
}

}  // namespace galilean::monitor::top
