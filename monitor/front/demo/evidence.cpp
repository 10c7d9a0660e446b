// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/evidence.h"

#include <iomanip>
#include <sstream>

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::front {
namespace {
constexpr double kEnough_m = 1;
}

Evidence::Evidence(std::vector<std::string> robots) {
  for (auto& robot : robots) deeds_[std::move(robot)];
}

void Evidence::note(const msg::RobotState& state) {
  const auto found = deeds_.find(state.robot);
  if (found == deeds_.end()) return;
  Deeds& deeds = found->second;
  const Vec2 position_m(state.x_m, state.y_m);
  if (deeds.messages++ > 0) deeds.driven_m += (position_m - deeds.position_m).norm();
  deeds.position_m = position_m;
  deeds.program_hash = state.program_hash;
  deeds.program_name = state.program_name;
  deeds.state = state.state;
  deeds.transitions = state.transitions;
  deeds.overruns = state.overruns;
}

std::uint32_t Evidence::deposited_by(const std::string& robot) const {
  for (const auto& score : score_.robots)
    if (score.robot == robot) return score.deposited;
  return 0;
}

std::vector<std::string> Evidence::shortcomings() const {
  std::vector<std::string> missing;
  for (const auto& [robot, deeds] : deeds_) {
    if (deeds.messages == 0)
      missing.push_back(robot + " sent nothing");
    else if (deeds.program_hash.empty())
      missing.push_back(robot + " runs no program");
    else if (deeds.transitions == 0)
      missing.push_back(robot + " never left its state '" + visible(deeds.state) + "'");
    else if (deeds.driven_m < kEnough_m && deposited_by(robot) == 0)
      missing.push_back(robot + " drove less than a metre and threw nothing away");
  }
  return missing;
}

std::string Evidence::summary() const {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  for (const auto& [robot, deeds] : deeds_)
    out << "  " << std::left << std::setw(12) << robot << visible(deeds.program_name) << ", in '"
        << visible(deeds.state) << "' after " << plural(deeds.transitions, "transition")
        << "; drove " << deeds.driven_m << " m, threw away " << plural(deposited_by(robot), "piece")
        << ", " << plural(deeds.overruns, "late tick") << "\n";
  if (score_.phase.empty())
    out << "  referee     sent no score\n";
  else
    out << "  referee     contest " << score_.phase << ", " << score_.deposited << " of "
        << plural(score_.pieces, "piece") << ", " << plural(score_.collisions, "collision") << ", "
        << score_.points << " points after " << score_.elapsed_s << " s, " << score_.remaining_s
        << " s left\n";
  return out.str();
}

}  // namespace galilean::front
