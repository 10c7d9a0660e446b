// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/push_ledger.h"

#include <utility>

#include "robot/telemetry/words.h"

namespace galilean::robot {

using Replies = std::vector<msg::ProgramReply>;
namespace status = msg::ProgramReply_Constants;

PushLedger::Running PushLedger::running() const {
  const std::lock_guard lock(mutex_);
  return running_;
}

std::shared_ptr<const Description> PushLedger::runs_now() const {
  return executive_.description(executive_.running());
}

std::string PushLedger::running_hash() const {
  const auto runs = runs_now();
  return runs ? runs->program.hash : "";
}

/// Requires: mutex_ is locked.
void PushLedger::note_pushed(ProgramId program) {
  pushed_.insert(program);
  if (pushed_.size() > kPushedKept) pushed_.erase(pushed_.begin());
}

bool PushLedger::pushed(ProgramId program) const {
  const std::lock_guard lock(mutex_);
  return pushed_.contains(program);
}

Result<Replies> PushLedger::load(bhdl::Program program, const ProbationRules& rules, Push push,
                                 const std::string& replaces) {
  // The lock covers it all, so that the push is known before its program can begin to run. Events
  // wait meanwhile: what was told is never newer than what runs.
  const std::lock_guard lock(mutex_);
  const auto runs = runs_now();
  const std::string hash = runs ? runs->program.hash : "";
  if (!replaces.empty() && replaces != hash)
    return Error{"it is meant to replace program " + replaces + ", but " +
                 (hash.empty() ? "no program" : "program " + hash) + " runs"};
  if (runs && hash == push.hash) {
    note_pushed(runs->id);
    if (running_.program && running_.program->id == runs->id) return join_running(std::move(push));
    joined_.emplace(runs->id, std::move(push));
    return Replies{};
  }
  const auto loaded = executive_.load(std::move(program), rules);
  if (!loaded) return loaded.error();
  pushes_.emplace(loaded.value(), std::move(push));
  note_pushed(loaded.value());
  return Replies{};
}

/// Requires: mutex_ is locked, and the push is of the program that events told of last.
Replies PushLedger::join_running(Push push) {
  Replies replies{reply(push, status::RUNNING)};
  replies.front().message = "it runs already";
  replies.front().tick = running_.since_tick;
  if (running_.proven)
    replies.push_back(reply(push, status::CONFIRMED));
  else
    pushes_.emplace(running_.program->id, std::move(push));
  return replies;
}

void PushLedger::answer_those_who_joined(ProgramId program, Replies& replies) {
  for (auto [push, end] = joined_.equal_range(program); push != end; ++push)
    for (auto& made : join_running(std::move(push->second))) replies.push_back(std::move(made));
  joined_.erase(program);
}

Result<void> PushLedger::roll_back(Push order, std::string_view reason) {
  const std::lock_guard lock(mutex_);
  const auto runs = runs_now();
  const std::string hash = runs ? runs->program.hash : "";
  if (order.hash != hash)
    return Error{"it cannot be rolled back, because " +
                 (hash.empty() ? "no program" : "program " + hash) + " runs"};
  if (!running_.program || running_.program->id != runs->id)
    return Error{
        "it cannot be rolled back yet, because it is not told yet how it began: order it "
        "again"};
  if (!running_.has_predecessor)
    return Error{"it cannot be rolled back, because no program ran before it"};
  if (!executive_.roll_back(running_.program->id, reason))
    return Error{"too many rollback orders wait for the control loop"};
  orders_.emplace(running_.program->id, std::move(order));
  return {};
}

Replies PushLedger::answers(const Event& event) {
  const std::lock_guard lock(mutex_);
  switch (event.kind) {
    case Event::Kind::kStarted:
    case Event::Kind::kSwapped:
      return started(event);
    case Event::Kind::kConfirmed:
      return confirmed(event);
    case Event::Kind::kRolledBack:
      return rolled_back(event);
    case Event::Kind::kTransition:
    case Event::Kind::kSchemaFailed:
      break;
  }
  return {};
}

Replies PushLedger::started(const Event& event) {
  pushes_.erase(pushes_.begin(), pushes_.lower_bound(event.from_program));
  const auto before = std::exchange(running_.program, executive_.description(event.program));
  running_.since_tick = event.tick;
  running_.proven = event.kind == Event::Kind::kStarted;
  running_.has_predecessor = !running_.proven;
  Replies replies;
  for (auto [order, end] = orders_.equal_range(event.from_program); order != end; ++order) {
    msg::ProgramReply& made = replies.emplace_back(reply(order->second, status::REJECTED));
    made.message = "another program had already replaced it";
  }
  orders_.erase(event.from_program);
  for (auto [push, end] = pushes_.equal_range(event.program); push != end; ++push) {
    msg::ProgramReply& made = replies.emplace_back(reply(push->second, status::RUNNING));
    made.tick = event.tick;
    made.swap_tick_us = static_cast<float>(to_seconds(event.tick_time) * 1e6);
    if (before && running_.program)
      made.kept_variables = kept_variables(*before, *running_.program);
    made.diagnostics = push->second.warnings;
  }
  answer_those_who_joined(event.program, replies);
  return replies;
}

Replies PushLedger::confirmed(const Event& event) {
  running_.proven = true;
  Replies replies;
  for (auto [push, end] = pushes_.equal_range(event.program); push != end; ++push)
    replies.push_back(reply(push->second, status::CONFIRMED));
  pushes_.erase(pushes_.begin(), pushes_.upper_bound(event.program));
  return replies;
}

Replies PushLedger::rolled_back(const Event& event) {
  const auto failed = std::exchange(running_.program, executive_.description(event.program));
  running_.since_tick = event.tick;
  running_.proven = !event.in_probation;
  running_.has_predecessor = event.in_probation;
  Replies replies;
  for (auto* concerned : {&pushes_, &orders_}) {
    for (auto [push, end] = concerned->equal_range(event.from_program); push != end; ++push)
      replies.push_back(rollback_reply(push->second, event, failed.get()));
    concerned->erase(concerned->upper_bound(event.program),
                     concerned->upper_bound(event.from_program));
  }
  answer_those_who_joined(event.program, replies);
  return replies;
}

msg::ProgramReply PushLedger::rollback_reply(const Push& push, const Event& event,
                                             const Description* failed) const {
  msg::ProgramReply made = reply(push, status::ROLLED_BACK);
  if (failed) made.message = fault_of(event, *failed);
  made.tick = event.tick;
  made.swap_tick_us = static_cast<float>(to_seconds(event.tick_time) * 1e6);
  return made;
}

msg::ProgramReply PushLedger::reply(const Push& push, std::uint8_t status) const {
  msg::ProgramReply reply;
  reply.id = push.id;
  reply.hash = push.hash;
  reply.running_hash = running_.hash();
  reply.status = status;
  return reply;
}

}  // namespace galilean::robot
