// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/wire/messages.h"
#include "monitor/team/break_reason.h"
#include "monitor/top/model/view_parts.h"

namespace galilean::monitor::top {
namespace {

bool has_unseen_alarm(const AlarmBoard* board, const std::string& robot) {
  return board && std::ranges::any_of(board->posted(), [&](const PostedAlarm& posted) {
           return !posted.seen && posted.alarm.robot == robot;
         });
}

/// Returns 0 for those that need somebody most.
int rank_of(const ShownRobot& robot) {
  if (robot.status.health == Health::kSilent) return 0;
  if (robot.has_unseen_alarm) return 1;
  return robot.status.health == Health::kTroubled ? 2 : 3;
}

void show_robots(const Sources& sources, const Choice& choice, View& view) {
  std::string chosen = choice.robot;
  const Team& team = sources.model.team();
  if (!team.find(chosen) && !team.robots().empty()) chosen = team.robots().begin()->first;
  view.known_robots = team.robots().size();
  for (auto& status : team.statuses()) {
    const bool is_wanted = contains(status.name, choice.robot_filter) ||
                           contains(status.state, choice.robot_filter) ||
                           contains(status.program_name, choice.robot_filter);
    if (!is_wanted && status.name != chosen) continue;
    const Identity& identity = sources.identities.of(status.name);
    const bool alarmed = has_unseen_alarm(sources.board, status.name);
    const auto& breaks = team.find(status.name)->breaks;
    view.robots.push_back({identity.letter, identity.number, std::move(status), alarmed,
                           breaks && breaks->stopped, breaks && waits_at_lock(*breaks)});
  }
  std::ranges::stable_sort(view.robots, {}, rank_of);
  const auto at = std::ranges::find_if(
      view.robots, [&](const ShownRobot& robot) { return robot.status.name == chosen; });
  view.chosen = at == view.robots.end() ? 0 : static_cast<std::size_t>(at - view.robots.begin());
}

void show_team_map(const msg::ObjectMap& map, double age_s, View& view) {
  view.map_title = "the team's map";
  for (const auto& object : map.objects) {
    const double certainty = std::max(0.0, object.certainty - object.decay_per_s * age_s);
    view.objects.push_back({object.object_class, {object.x_m, object.y_m}, certainty});
  }
  for (const auto& robot : map.robots)
    for (std::size_t i = 0; i < view.robots.size(); ++i)
      if (view.robots[i].status.name == robot.name)
        view.poses.push_back({i, {{robot.x_m, robot.y_m}, robot.heading_rad}});
}

void show_own_map(const DashboardModel& model, View& view) {
  const RobotStatus& status = view.robots[view.chosen].status;
  const auto* seen = model.sightings(status.name);
  // What robots see is read of the one that is shown alone.
  view.map_title = status.name + "'s own frame (no monitor" +
                   (view.is_past && !seen ? "; what it saw then was not read)" : ")");
  if (status.has_state)
    view.poses.push_back({view.chosen, {{status.x_m, status.y_m}, status.heading_rad}});
  if (!seen) return;
  for (const auto& sighting : seen->items)
    view.objects.push_back({sighting.object_class, {sighting.x_m, sighting.y_m}, 1});
}

}  // namespace

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end() ||
         part.empty();
}

View make_view(const Sources& sources, const Choice& choice) {
  View view;
  const auto& [model, clock, identities, curves, board, present] = sources;
  view.now = present ? present->now() : clock.now();
  view.is_past = present != nullptr;
  show_robots(sources, choice, view);
  view.score = model.team().score();
  if (board) view.alarms = board->posted();
  if (view.robots.empty()) return view;
  const Robot& robot = *model.team().find(view.robots[view.chosen].status.name);
  show_machine(robot, choice.state, view);
  show_changes(robot, to_seconds(clock.now() - robot.state_received), view);
  show_variables(sources, robot, choice.variable_filter, view);
  if (const auto* map = model.objects()) {
    show_team_map(*map, to_seconds(clock.now() - model.objects_received()), view);
    view.floor = model.floor();
  } else {
    show_own_map(model, view);
  }
  return view;
}

}  // namespace galilean::monitor::top
