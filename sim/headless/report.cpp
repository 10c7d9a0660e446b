// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/plural.h"

namespace galilean::sim {
namespace {

using nlohmann::ordered_json;

double rounded(double number) {
  return std::round(number * 1000) / 1000;
}

std::string hexadecimal(std::uint64_t number) {
  std::ostringstream text;
  text << std::hex;
  text.width(16);
  text.fill('0');
  text << number;
  return text.str();
}

/// Returns the count under the key with its noun.
std::string counted(const ordered_json& report, const char* key, const char* noun) {
  return plural(report[key].get<std::uint64_t>(), noun);
}

ordered_json report_robot(const HeadlessContest& contest, std::size_t index) {
  const HeadlessRobot& robot = contest.robot(index);
  const RobotTally& tally = contest.world().referee().robots()[index];
  const RobotStatistics statistics = robot.statistics();
  ordered_json states = ordered_json::object();
  for (const auto& [state, seconds] : statistics.seconds_in_state) states[state] = rounded(seconds);
  return {{"name", robot.name()},
          {"deposited", tally.deposited},
          {"collisions", tally.collisions},
          {"distance_m", rounded(statistics.distance_m)},
          {"drift_m", rounded(statistics.drift_m)},
          {"longest_stuck_s", rounded(statistics.stuck.longest_s())},
          {"transitions", robot.executive().transitions()},
          {"seconds_in_state", states},
          {"problems", robot.problems()}};
}

}  // namespace

ordered_json report(const HeadlessContest& contest, const HeadlessOptions& options,
                    const bhdl::Program& program, double wall_s) {
  const Referee& referee = contest.world().referee();
  ordered_json robots = ordered_json::array();
  double longest_stuck_s = 0;
  for (std::size_t i = 0; i < contest.robot_count(); ++i) {
    robots.push_back(report_robot(contest, i));
    longest_stuck_s = std::max(longest_stuck_s, contest.robot(i).statistics().stuck.longest_s());
  }
  return {{"scenario", contest.world().scenario().name},
          {"program", program.name},
          {"program_hash", program.hash},
          {"seed", options.seed},
          {"pieces", contest.world().objects().pieces().size()},
          {"deposited", referee.deposited()},
          {"collisions", referee.collisions()},
          {"score", referee.score()},
          {"longest_stuck_s", rounded(longest_stuck_s)},
          {"simulated_seconds", rounded(contest.simulated_s())},
          {"wall_seconds", rounded(wall_s)},
          {"hash", hexadecimal(contest.hash())},
          {"robots", robots}};
}

std::string summary(const ordered_json& report) {
  std::ostringstream text;
  text << report["scenario"].get<std::string>() << ", " << report["program"].get<std::string>()
       << ", seed " << report["seed"] << ": " << report["deposited"] << " of "
       << counted(report, "pieces", "piece") << ", " << counted(report, "collisions", "collision")
       << ", score " << report["score"] << "\n";
  for (const auto& robot : report["robots"])
    text << "  " << robot["name"].get<std::string>() << ": " << counted(robot, "deposited", "piece")
         << ", " << counted(robot, "collisions", "collision") << ", " << robot["distance_m"]
         << " m driven, stuck for " << robot["longest_stuck_s"] << " s at most\n";
  text << report["simulated_seconds"] << " simulated seconds in " << report["wall_seconds"]
       << " s; final state " << report["hash"].get<std::string>() << "\n";
  return text.str();
}

}  // namespace galilean::sim
