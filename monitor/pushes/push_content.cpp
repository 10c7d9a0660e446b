// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_content.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "monitor/pushes/history/push_messages.h"

namespace galilean::monitor {
namespace {

/// A length of 0 would mean to a robot that its own rules hold. This one is over after a tick.
constexpr Duration kShortestProbation = std::chrono::milliseconds(1);

}  // namespace

PushContent::PushContent(PushOrder order, PushIdentity identity)
    : order_(std::move(order)), identity_(std::move(identity)), is_ours_(true) {}

PushContent::PushContent(const msg::ProgramPush& message)
    : order_{.files = {}, .targets = message.targets, .author = message.author},
      identity_{.id = message.id, .pushed_ns = wire::since_epoch_ns(message.stamp)},
      is_ours_(false) {
  // Whatever it announces: what its files have is what a robot can be asked to run.
  message_.hash = hash_of_files(message);
  if (!message.files.empty()) message_.files.push_back({message.files.front().path, {}});
}

void PushContent::set_program(const CheckedProgram& program) {
  message_.stamp = wire::ros_time(identity_.pushed_ns);
  message_.id = identity_.id;
  message_.author = order_.author;
  message_.targets = order_.targets;
  message_.replaces_hash = program.replaces_hash;
  message_.hash = program.hash;
  taken_ = program.taken;
  for (const auto& file : program.files) message_.files.push_back({file.path, file.text});
  if (!order_.probation) return;
  // The robot's probation must last until the monitor has decided whether the canary rolls back.
  const Duration more = order_.canary.empty() ? Duration() : kReplyTimeout;
  message_.probation_s =
      static_cast<float>(to_seconds(std::max(*order_.probation + more, kShortestProbation)));
}

RolloutPlan PushContent::plan(const OrderTargets& targets) const {
  RolloutPlan plan{.push_id = identity_.id,
                   .awaited = targets.names(),
                   .silent = targets.silent,
                   .canary = order_.canary};
  if (order_.probation) plan.probation = *order_.probation;
  return plan;
}

Steps PushContent::steps(bool has_rest) const {
  Steps steps;
  const bool has_canary = !order_.canary.empty();
  if (!order_.trial.wanted) steps.leave_out(StepKind::kTry);
  if (order_.trial.only || !has_canary) steps.leave_out(StepKind::kCanary);
  if (order_.trial.only || (has_canary && !has_rest)) steps.leave_out(StepKind::kRest);
  return steps;
}

CheckProgram PushContent::check(std::vector<Target> robots) const {
  return {order_.files, std::move(robots), order_.replaces};
}

TryProgram PushContent::trial(std::vector<std::string> robots) const {
  TryProgram trial{.files = {}, .robots = std::move(robots), .options = order_.trial};
  for (const auto& file : message_.files) trial.files.push_back({file.path, file.text});
  return trial;
}

SendProgram PushContent::sending(std::vector<std::string> robots) const {
  SendProgram send{.push = message_};
  send.push.targets = robots;
  send.awaited = std::move(robots);
  return send;
}

SendProgram PushContent::to_canary() const {
  return sending({order_.canary});
}

SendProgram PushContent::to_rest(std::vector<std::string> rest) const {
  // A canary runs the program already. Without a canary, the targets are sent as they were ordered:
  // an empty list reaches robots, too, that this monitor does not hear.
  auto send = sending(std::move(rest));
  if (order_.canary.empty()) send.push.targets = order_.targets;
  send.is_for_team = order_.targets.empty();
  return send;
}

RollBack PushContent::rollback(const std::string& reason) const {
  return {.order_id = identity_.rollback_id,
          .author = order_.author,
          .robot = order_.canary,
          .hash = message_.hash,
          .reason = reason};
}

bool PushContent::is_meant_by(const msg::ProgramReply& reply) const {
  if (reply.id == identity_.id) return true;
  return is_ours_ && reply.id == identity_.rollback_id &&
         reply_status(reply.status) == ReplyStatus::kRolledBack;
}

PushRecord PushContent::record(Progress progress, std::vector<RobotReply> replies) const {
  std::string program;
  if (!message_.files.empty())
    program = message_.files.front().path;
  else if (!order_.files.empty())
    program = order_.files.front().path;
  return {.id = identity_.id,
          .pushed_ns = identity_.pushed_ns,
          .author = order_.author,
          .program = std::move(program),
          .hash = message_.hash,
          .targets = order_.targets,
          .progress = std::move(progress),
          .replies = std::move(replies)};
}

}  // namespace galilean::monitor
