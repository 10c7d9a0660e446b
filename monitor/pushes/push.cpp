// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push.h"

#include <algorithm>
#include <array>

namespace galilean::monitor {
namespace status = msg::ProgramReply_Constants;

std::string push_status_name(std::uint8_t status) {
  static constexpr std::array kNames{"no_answer", "received",  "rejected",
                                     "running",   "confirmed", "rolled_back"};
  return status < kNames.size() ? kNames[status] : "unknown";
}

Push::Push(std::string id, std::vector<std::string> awaited, Time sent)
    : id_(std::move(id)), awaited_(std::move(awaited)), sent_(sent) {
  for (const auto& robot : awaited_) list(robot);
}

void Push::list(const std::string& robot) {
  answers_[robot].robot = robot;
}

bool Push::note(const msg::ProgramReply& reply, Time now) {
  if (reply.id != id_) return false;
  list(reply.robot);
  PushAnswer& answer = answers_[reply.robot];
  // The numbers rise in the order in which a robot says them; a repeat tells nothing new.
  if (reply.status <= answer.reply.status) return false;
  const bool first_outcome = answer.reply.status <= status::RECEIVED;
  // Only the swap itself tells what was kept and how long it took.
  auto kept = std::move(answer.reply.kept_variables);
  const float swap_tick_us = answer.reply.swap_tick_us;
  answer.reply = reply;
  if (!first_outcome) {
    answer.reply.kept_variables = std::move(kept);
    answer.reply.swap_tick_us = swap_tick_us;
  }
  answer.status = push_status_name(reply.status);
  if (first_outcome) answer.latency_ms = to_seconds(now - sent_) * 1e3;
  return true;
}

bool Push::all_awaited(const std::function<bool(std::uint8_t)>& have) const {
  return std::ranges::all_of(
      awaited_, [&](const auto& robot) { return have(answers_.at(robot).reply.status); });
}

bool Push::complete() const {
  return all_awaited([](std::uint8_t said) { return said > status::RECEIVED; });
}

bool Push::taken_by_all() const {
  return all_awaited(
      [](std::uint8_t said) { return said == status::RUNNING || said == status::CONFIRMED; });
}

bool Push::settled() const {
  return all_awaited(
      [](std::uint8_t said) { return said == status::REJECTED || said > status::RUNNING; });
}

std::vector<PushAnswer> Push::answers() const {
  std::vector<PushAnswer> result;
  for (const auto& [robot, answer] : answers_) result.push_back(answer);
  return result;
}

}  // namespace galilean::monitor
