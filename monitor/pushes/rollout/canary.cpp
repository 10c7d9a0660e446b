// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/rollout/canary.h"

#include <array>
#include <cstdio>
#include <utility>

#include "core/cut_text.h"

namespace galilean::monitor {
namespace {

using Kind = Verdict::Kind;

std::string seconds_text(Duration duration) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g s", to_seconds(duration));
  return text.data();
}

}  // namespace

Canary::Canary(const std::string& push_id, std::string robot, Duration probation, Time sent)
    : robot_(std::move(robot)),
      probation_(probation),
      sent_(sent),
      replies_(push_id, {robot_}, sent) {}

bool Canary::may_run_it() const {
  const auto status = reply().status;
  return status != ReplyStatus::kRejected && status != ReplyStatus::kRolledBack;
}

Verdict Canary::judge(Time now) {
  if (!may_run_it()) return {Kind::kFailed, failure_reason(reply())};
  if (!replies_.taken_by_all()) {
    if (now - sent_ < kReplyTimeout) return {};
    return {Kind::kFailed, robot_ + " did not answer within " + seconds_text(kReplyTimeout)};
  }
  if (!runs_since_) runs_since_ = now;
  if (now - *runs_since_ < probation_)
    return {Kind::kUnderWay, robot_ + " runs it, on probation for " + seconds_text(probation_)};
  return {Kind::kDone, robot_ + " ran it for " + seconds_text(probation_)};
}

Verdict Canary::see(bool silent, const std::string& running_hash, Time now) const {
  if (!runs_since_) return {};
  if (silent) return {Kind::kFailed, robot_ + " fell silent on its probation"};
  // A RobotState that was sent before the swap still has the hash of the previous program.
  const bool settled = now - *runs_since_ >= kReplyTimeout / 2;
  const std::string pushed = reply().reply.hash;
  if (settled && !pushed.empty() && running_hash != pushed)
    return {Kind::kFailed,
            robot_ + " runs another program now: " + std::string(cut_text(running_hash, 8))};
  return {};
}

}  // namespace galilean::monitor
