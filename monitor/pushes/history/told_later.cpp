// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/told_later.h"

#include <algorithm>

#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

bool is_last_step(const Step& step, StepState state) {
  return (step.kind == StepKind::kCanary || step.kind == StepKind::kRest) && step.state == state;
}

/// Returns the step at which the push ended; null if it ended otherwise.
const Step* end_of(const PushRecord& push) {
  const bool waits = std::ranges::any_of(
      push.progress.steps, [](const Step& step) { return step.state == StepState::kWaiting; });
  if (waits || push.replies.empty()) return nullptr;
  for (const auto& step : push.progress.steps) {
    // A canary whose step failed was ordered back to the program that it ran before.
    if (push.progress.state == PushState::kFailed && step.kind == StepKind::kRest &&
        step.state == StepState::kFailed)
      return &step;
    if (push.progress.state == PushState::kInterrupted && is_last_step(step, StepState::kRunning))
      return &step;
  }
  return nullptr;
}

}  // namespace

bool may_be_told_later(const PushRecord& push) {
  return end_of(push) != nullptr;
}

std::optional<Progress> told_later(const PushRecord& push, std::int64_t now_ns) {
  const Step* end = end_of(push);
  if (!end) return std::nullopt;
  std::string robots;
  for (const auto& reply : push.replies) {
    if (reply.status != ReplyStatus::kConfirmed) return std::nullopt;
    robots += (robots.empty() ? "" : ", ") + reply.robot;
  }
  Progress progress = push.progress;
  progress.state = PushState::kToldLater;
  progress.told_ns = now_ns;
  for (auto& step : progress.steps)
    if (step.kind == end->kind)
      step = {step.kind, StepState::kDone,
              "confirmed (told later) by " + robots +
                  (end->detail.empty() ? "" : "; it had ended as: " + end->detail)};
  return progress;
}

bool is_undecided(ReplyStatus status) {
  return status == ReplyStatus::kNoAnswer || status == ReplyStatus::kReceived ||
         status == ReplyStatus::kRunning;
}

std::vector<RobotReply> undecided(const PushRecord& push) {
  const auto state = push.progress.state;
  if (state == PushState::kRunning || state == PushState::kForeign) return {};
  std::vector<RobotReply> found;
  for (const auto& reply : push.replies)
    if (is_undecided(reply.status)) found.push_back(reply);
  return found;
}

std::optional<RobotReply> with_late_reply(const PushRecord& push, const msg::ProgramReply& reply) {
  const auto known = std::ranges::find(push.replies, reply.robot, &RobotReply::robot);
  RobotReply late;
  if (known != push.replies.end()) late = *known;
  const auto status = reply_status(reply.status);
  if (status == ReplyStatus::kUnknown || status <= late.status) return std::nullopt;
  const bool first_outcome = late.status <= ReplyStatus::kReceived;
  late.robot = reply.robot;
  late.status = status;
  late.reply = reply;
  const auto took_ns = wire::since_epoch_ns(reply.stamp) - push.pushed_ns;
  if (first_outcome && took_ns > 0) late.latency_ms = static_cast<double>(took_ns) * 1e-6;
  return late;
}

}  // namespace galilean::monitor
