// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/rollout/rollout.h"

#include <algorithm>

namespace galilean::monitor {

void Rollout::begin_canary(Time now) {
  canary_.emplace(plan_.push_id, plan_.canary, plan_.probation, now);
}

void Rollout::begin_rest(Time now) {
  rest_sent_ = now;
  auto awaited = plan_.awaited;
  awaited.insert(awaited.end(), plan_.silent.begin(), plan_.silent.end());
  std::erase(awaited, plan_.canary);
  rest_.emplace(plan_.push_id, std::move(awaited), now);
}

std::optional<RobotReply> Rollout::note(const msg::ProgramReply& reply, Time now) {
  const bool of_canary = canary_ && reply.robot == plan_.canary;
  const bool is_new = of_canary ? canary_->note(reply, now) : rest_ && rest_->note(reply, now);
  if (!is_new) return std::nullopt;
  const auto all = replies();
  return *std::ranges::find(all, reply.robot, &RobotReply::robot);
}

Verdict Rollout::judge_rest(Time now) const {
  if (rest_->taken_by_all()) return {.kind = Verdict::Kind::kDone};
  const bool is_over = rest_->complete() || now - rest_sent_ >= kReplyTimeout;
  return is_over ? Verdict{Verdict::Kind::kFailed, shortcomings()} : Verdict{};
}

std::vector<std::string> Rollout::rest() const {
  auto robots = plan_.awaited;
  robots.insert(robots.end(), plan_.silent.begin(), plan_.silent.end());
  std::erase(robots, plan_.canary);
  return robots;
}

std::vector<RobotReply> Rollout::replies() const {
  auto all = rest_ ? rest_->all() : std::vector<RobotReply>();
  if (canary_) all.push_back(canary_->reply());
  std::ranges::sort(all, {}, &RobotReply::robot);
  return all;
}

/// Returns a text such as "callisto has not answered; ganymede refused it: no camera".
std::string Rollout::shortcomings() const {
  std::string text;
  for (const auto& reply : replies()) {
    if (runs(reply.status)) continue;
    text += (text.empty() ? "" : "; ") + failure_reason(reply);
  }
  return text;
}

}  // namespace galilean::monitor
