// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/team_json.h"

#include "monitor/team/break_reason.h"

namespace galilean::monitor {
namespace {

nlohmann::json variables_json(const Team& team, const Robot& robot) {
  auto variables = nlohmann::json::array();
  for (const auto& variable : robot.variables.items)
    variables.push_back({{"name", variable.name},
                         {"type", variable.type},
                         {"object_class", variable.object_class},
                         {"valid", variable.valid},
                         {"certainty", team.certainty_now(robot, variable)},
                         {"decay_per_s", variable.decay_per_s},
                         {"values", variable.values}});
  return variables;
}

nlohmann::json transitions_json(const Robot& robot) {
  auto transitions = nlohmann::json::array();
  for (const auto& transition : robot.transitions)
    transitions.push_back({{"number", transition.number},
                           {"from_state", transition.from_state},
                           {"to_state", transition.to_state},
                           {"cause", transition.cause},
                           {"file", transition.file},
                           {"line", transition.line},
                           {"filled", robot.is_filled(transition.number)}});
  return transitions;
}

nlohmann::json point_json(const msg::BreakPoint& point) {
  return {{"from", point.from_state},
          {"to", point.to_state},
          {"kind", msg::name_of(msg::BreakPoint_Constants::kAll, point.kind)}};
}

/// Returns the members of the robot's Breaks, or null before the first one came.
nlohmann::json breaks_json(const Team& team, const Robot& robot) {
  if (!robot.breaks) return nullptr;
  const msg::Breaks& breaks = *robot.breaks;
  auto points = nlohmann::json::array();
  for (const auto& point : breaks.points) points.push_back(point_json(point));
  auto answers = nlohmann::json::array();
  for (const auto& answer : breaks.answers)
    answers.push_back({{"id", answer.id}, {"refused", answer.refused}});
  const auto& at = breaks.break_point;
  const bool is_known = !at.from_state.empty() || !at.to_state.empty();
  // Whether a silent robot still waits is not known: it has waited as long as it told last.
  const Duration since_told = team.silent(robot) ? Duration{} : team.since_breaks(robot);
  const double waits_s = waits_at_lock(breaks) ? lock_wait_s(breaks, since_told) : 0.0;
  return {{"points", std::move(points)},
          {"stepping", breaks.stepping},
          {"stopped", breaks.stopped},
          {"stopped_at", breaks.stopped_at},
          {"stopped_by", msg::name_of(msg::Breaks_Constants::kAll, breaks.stopped_by)},
          {"break_robot", breaks.break_robot},
          {"break_point", is_known ? point_json(at) : nlohmann::json()},
          {"author", breaks.author},
          {"waits_at_from", breaks.waits_at_from},
          {"waits_at_to", breaks.waits_at_to},
          {"waits_s", waits_s},
          {"answers", std::move(answers)}};
}

}  // namespace

nlohmann::json to_json(const RobotStatus& status) {
  return {{"name", status.name},
          {"replayed", status.replayed},
          {"health", to_string(status.health)},
          {"silent", status.health == Health::kSilent},
          {"age_s", status.age_s},
          {"state", status.state},
          {"in_state_s", status.in_state_s},
          {"program_name", status.program_name},
          {"program_hash", status.program_hash},
          {"drifting", status.drifting},
          {"held", status.held},
          {"break_reason", status.break_reason},
          {"out_of_service", status.out_of_service},
          {"in_probation", status.in_probation},
          {"tick", status.tick},
          {"tick_time_us", status.tick_time_us},
          {"tick_time_max_us", status.tick_time_max_us},
          {"overruns", status.overruns},
          {"least_certain", status.least_certain},
          {"lowest_certainty", status.lowest_certainty},
          {"x_m", status.x_m},
          {"y_m", status.y_m},
          {"heading_rad", status.heading_rad},
          {"problems", status.problems}};
}

nlohmann::json score_json(const Team& team) {
  if (!team.score()) return nullptr;
  const auto& score = *team.score();
  auto robots = nlohmann::json::array();
  for (const auto& robot : score.robots)
    robots.push_back(
        {{"robot", robot.robot}, {"deposited", robot.deposited}, {"collisions", robot.collisions}});
  return {
      {"scenario", score.scenario},       {"phase", score.phase},   {"elapsed_s", score.elapsed_s},
      {"remaining_s", score.remaining_s}, {"pieces", score.pieces}, {"deposited", score.deposited},
      {"collisions", score.collisions},   {"points", score.points}, {"robots", std::move(robots)}};
}

nlohmann::json strategies_json(const Team& team) {
  auto json = nlohmann::json::array();
  for (const auto& strategy : team.strategies())
    json.push_back({{"program_name", strategy.program_name},
                    {"program_hash", strategy.program_hash},
                    {"robot_seconds", strategy.robot_seconds},
                    {"deposited", strategy.deposited},
                    {"collisions", strategy.collisions},
                    {"points", strategy.points}});
  return json;
}

nlohmann::json to_json(const Team& team) {
  auto robots = nlohmann::json::array();
  for (const auto& [name, robot] : team.robots()) {
    auto json = to_json(team.status(robot));
    json["variables"] = variables_json(team, robot);
    json["transitions"] = transitions_json(robot);
    json["breaks"] = breaks_json(team, robot);
    robots.push_back(std::move(json));
  }
  return {{"program_hash", team.program_hash()},
          {"robots", std::move(robots)},
          {"score", score_json(team)}};
}

}  // namespace galilean::monitor
