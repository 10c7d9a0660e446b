// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/late_replies.h"

#include <algorithm>
#include <iostream>
#include <set>
#include <utility>

#include "core/cut_text.h"
#include "monitor/pushes/history/told_later.h"

namespace galilean::monitor {
namespace {

/// The number of a former monitor's pushes that are looked at.
constexpr int kMostLookedAt = 64;

void log_late_problem(const std::string& why) {
  std::clog << "galilean-monitor: what a robot told later was not kept: " << why << std::endl;
}

msg::ProgramReply reply_of_state(const std::string& push_id, const std::string& hash,
                                 const msg::RobotState& state) {
  const bool runs_it = state.program_hash == hash;
  namespace statuses = msg::ProgramReply_Constants;
  msg::ProgramReply reply;
  reply.stamp = state.stamp;
  reply.id = push_id;
  reply.robot = state.robot;
  reply.hash = hash;
  reply.running_hash = state.program_hash;
  reply.status = runs_it ? statuses::CONFIRMED : statuses::ROLLED_BACK;
  reply.message = runs_it ? "its state tells that it runs it"
                          : "its state tells that it runs another program: " +
                                std::string(cut_text(state.program_hash, 8));
  return reply;
}

}  // namespace

LateReplies::Open LateReplies::open_of(const PushRecord& push) {
  Open open{.id = push.id, .hash = push.hash, .robots = {}};
  for (const auto& robot : undecided(push))
    open.robots[robot.robot] = {.known = robot.status, .runs_it = false, .since = {}};
  return open;
}

void LateReplies::start() {
  worker_.run([this] { return history_.pushes(kMostLookedAt); },
              [this](const Result<std::vector<PushRecord>>& pushes) {
                if (!pushes) return log_late_problem(pushes.error().message);
                // A robot is watched for the newest push that was sent to it. A push that ended
                // meanwhile is newer than all of these.
                std::set<std::string> seen;
                for (const auto& open : open_)
                  for (const auto& [robot, watched] : open.robots) seen.insert(robot);
                for (const auto& push : pushes.value()) {
                  auto open = open_of(push);
                  std::erase_if(open.robots,
                                [&](const auto& each) { return seen.contains(each.first); });
                  for (const auto& reply : push.replies) seen.insert(reply.robot);
                  if (!open.robots.empty()) open_.push_back(std::move(open));
                }
              },
              log_late_problem);
}

void LateReplies::add(const PushRecord& push) {
  if (auto open = open_of(push); !open.robots.empty()) open_.push_back(std::move(open));
}

void LateReplies::supersede(const std::vector<std::string>& targets) {
  if (targets.empty()) return open_.clear();
  for (auto& open : open_)
    for (const auto& robot : targets) open.robots.erase(robot);
  std::erase_if(open_, [](const Open& open) { return open.robots.empty(); });
}

LateReplies::Watched* LateReplies::find(const std::string& push_id, const std::string& robot) {
  const auto open = std::ranges::find(open_, push_id, &Open::id);
  if (open == open_.end()) return nullptr;
  const auto watched = open->robots.find(robot);
  return watched == open->robots.end() ? nullptr : &watched->second;
}

void LateReplies::note(const msg::ProgramReply& reply) {
  // What a recording plays is of another time, and its robots are not there.
  const Robot* robot = team_.find(reply.robot);
  if (robot && team_.replayed(*robot)) return;
  if (Watched* watched = find(reply.id, reply.robot))
    watched->known = std::max(watched->known, reply_status(reply.status));
  worker_.run([this, reply] { return history_.add_late_reply(reply); },
              [this, reply](const Result<std::optional<PushRecord>>& marked) {
                if (!marked) return failed(reply, marked.error().message);
                if (marked.value()) report_(*marked.value());
              },
              [this, reply](const std::string& why) { failed(reply, why); });
}

// The robot's states go on to tell it, so that it is kept once the disk takes it.
void LateReplies::failed(const msg::ProgramReply& reply, const std::string& why) {
  log_late_problem(why);
  if (Watched* watched = find(reply.id, reply.robot)) {
    watched->known = ReplyStatus::kRunning;
    watched->since = clock_.now() + kSettled;
  }
}

void LateReplies::watch() {
  for (std::size_t each = 0; each < open_.size(); ++each)
    for (auto& [name, watched] : open_[each].robots) see(open_[each], name, watched);
}

void LateReplies::see(const Open& push, const std::string& name, Watched& watched) {
  if (!is_undecided(watched.known)) return;
  const Robot* robot = team_.find(name);
  const bool tells = robot && robot->state && !robot->state->program_hash.empty() &&
                     !robot->state->in_probation && !team_.silent(*robot) &&
                     !team_.replayed(*robot);
  const bool runs_it = tells && robot->state->program_hash == push.hash;
  // A robot that never told that it took the program need not run it.
  if (!tells || (!runs_it && watched.known != ReplyStatus::kRunning)) return watched.since.reset();
  if (!watched.since || watched.runs_it != runs_it) {
    watched.runs_it = runs_it;
    watched.since = clock_.now();
  }
  // A state that was sent before the swap tells of the program before.
  if (robot->state_received - *watched.since < kSettled) return;
  note(reply_of_state(push.id, push.hash, *robot->state));
}

}  // namespace galilean::monitor
