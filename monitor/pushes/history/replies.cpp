// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/replies.h"

#include <algorithm>

namespace galilean::monitor {

ReplyStatus reply_status(std::uint8_t number) {
  constexpr auto kLast = static_cast<std::uint8_t>(ReplyStatus::kRolledBack);
  return number <= kLast ? static_cast<ReplyStatus>(number) : ReplyStatus::kUnknown;
}

std::string failure_reason(const RobotReply& reply) {
  const std::string more = reply.reply.message.empty() ? "" : ": " + reply.reply.message;
  if (reply.status == ReplyStatus::kRejected) return reply.robot + " refused it" + more;
  if (reply.status == ReplyStatus::kRolledBack) return reply.robot + " went back" + more;
  return reply.robot + " has not answered";
}

Replies::Replies(std::string push_id, std::vector<std::string> awaited, Time sent)
    : push_id_(std::move(push_id)), awaited_(std::move(awaited)), sent_(sent) {
  for (const auto& robot : awaited_) list(robot);
}

void Replies::list(const std::string& robot) {
  replies_[robot].robot = robot;
}

void Replies::list_unasked(const std::string& robot) {
  unasked_.push_back(robot);
  list(robot);
  if (unasked_.size() <= kMostUnasked) return;
  ++dropped_;
  replies_.erase(unasked_.front());
  unasked_.pop_front();
}

bool Replies::note(const msg::ProgramReply& reply, Time now) {
  if (reply.id != push_id_) return false;
  if (!replies_.contains(reply.robot)) list_unasked(reply.robot);
  RobotReply& known = replies_[reply.robot];
  // A robot's statuses come in rising order, so one that is not higher tells nothing new.
  if (reply.status <= known.reply.status) return false;
  const bool first_outcome = known.status <= ReplyStatus::kReceived;
  // Only the reply to the swap itself has the kept variables and the duration.
  auto kept = std::move(known.reply.kept_variables);
  const float swap_tick_us = known.reply.swap_tick_us;
  known.reply = reply;
  if (!first_outcome) {
    known.reply.kept_variables = std::move(kept);
    known.reply.swap_tick_us = swap_tick_us;
  }
  known.status = reply_status(reply.status);
  if (first_outcome) known.latency_ms = to_seconds(now - sent_) * 1e3;
  return true;
}

bool Replies::all_awaited(const std::function<bool(ReplyStatus)>& have) const {
  return std::ranges::all_of(awaited_,
                             [&](const auto& robot) { return have(replies_.at(robot).status); });
}

bool Replies::complete() const {
  return all_awaited([](ReplyStatus said) { return said > ReplyStatus::kReceived; });
}

bool Replies::taken_by_all() const {
  return all_awaited(runs);
}

bool Replies::settled() const {
  return all_awaited([](ReplyStatus said) {
    return said == ReplyStatus::kRejected || said > ReplyStatus::kRunning;
  });
}

std::vector<RobotReply> Replies::all() const {
  std::vector<RobotReply> result;
  for (const auto& [robot, reply] : replies_) result.push_back(reply);
  return result;
}

}  // namespace galilean::monitor
