// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/late_replies.h"

#include <algorithm>
#include <deque>
#include <iostream>
#include <utility>

#include "monitor/pushes/history/told_later.h"
#include "monitor/pushes/push_order.h"

namespace galilean::monitor {
namespace {

/// The number of a former monitor's pushes that are looked at.
constexpr int kMostLookedAt = 64;

void log_late_problem(const std::string& why) {
  std::clog << "galilean-monitor: what a robot told later was not kept: " << why << std::endl;
}

/// Returns those of `pushes`, the newest first, that may be told of and that no newer one of them
/// went over.
std::vector<PushRecord> open_among(std::vector<PushRecord> pushes) {
  std::vector<PushRecord> open;
  std::vector<std::vector<std::string>> newer;
  for (auto& push : pushes) {
    const bool is_superseded = std::ranges::any_of(
        newer, [&](const auto& targets) { return overlap(targets, push.targets); });
    newer.push_back(push.targets);
    if (!is_superseded && may_be_told_later(push)) open.push_back(std::move(push));
  }
  return open;
}

msg::ProgramReply reply_of_state(const PushRecord& push, const msg::RobotState& state) {
  msg::ProgramReply reply;
  reply.stamp = state.stamp;
  reply.id = push.id;
  reply.robot = state.robot;
  reply.hash = reply.running_hash = push.hash;
  reply.status = msg::ProgramReply_Constants::CONFIRMED;
  reply.message = "its state tells that it runs it";
  return reply;
}

}  // namespace

void LateReplies::start() {
  worker_.run([this] { return history_.pushes(kMostLookedAt); },
              [this](Result<std::vector<PushRecord>> pushes) {
                if (!pushes) return log_late_problem(pushes.error().message);
                // A push that ended meanwhile is newer than all of them.
                for (auto& push : open_among(std::move(pushes).value()))
                  if (std::ranges::none_of(open_, [&](const auto& each) {
                        return overlap(each.targets, push.targets);
                      }))
                    open_.push_back(std::move(push));
              },
              log_late_problem);
}

void LateReplies::add(const PushRecord& push) {
  if (may_be_told_later(push)) open_.push_back(push);
}

void LateReplies::supersede(const std::vector<std::string>& targets) {
  std::erase_if(open_, [&](const PushRecord& push) { return overlap(push.targets, targets); });
}

void LateReplies::note(const msg::ProgramReply& reply) {
  // What a recording plays is of another time, and its robots are not there.
  const Robot* robot = team_.find(reply.robot);
  if (robot && team_.replayed(*robot)) return;
  worker_.run([this, reply] { return history_.add_late_reply(reply); },
              [this](const Result<std::optional<PushRecord>>& marked) {
                if (!marked) return log_late_problem(marked.error().message);
                if (!marked.value()) return;
                std::erase_if(
                    open_, [&](const PushRecord& push) { return push.id == marked.value()->id; });
                report_(*marked.value());
              },
              log_late_problem);
}

void LateReplies::watch() {
  for (auto& push : open_) see(push);
}

void LateReplies::see(PushRecord& push) {
  for (auto& known : push.replies) {
    const bool may_run_it = known.status == ReplyStatus::kNoAnswer ||
                            known.status == ReplyStatus::kReceived ||
                            known.status == ReplyStatus::kRunning;
    const Robot* robot = team_.find(known.robot);
    if (!may_run_it || !robot || !robot->state || team_.silent(*robot) || team_.replayed(*robot))
      continue;
    if (robot->state->program_hash != push.hash || robot->state->in_probation) continue;
    known.status = ReplyStatus::kConfirmed;  // so that it is noted once
    note(reply_of_state(push, *robot->state));
  }
}

}  // namespace galilean::monitor
