// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/break_desk.h"

#include <algorithm>

#include "robot/log/log.h"
#include "robot/telemetry/break_words.h"

namespace galilean::robot {
namespace {

std::vector<StateChange> changes_in(const msg::BreakOrder& order) {
  std::vector<StateChange> changes;
  for (const auto& point : order.points) changes.push_back({point.from_state, point.to_state});
  return changes;
}

}  // namespace

void BreakDesk::hold(const msg::Command& command) {
  const std::lock_guard lock(mutex_);
  ++told_.orders;
  log_info(command.author + " holds this robot");
  held_by_ = command.author.empty() ? "an operator" : command.author;
  executive_.hold();
}

void BreakDesk::stop_with_team(const msg::TeamStop& stop) {
  const std::lock_guard lock(mutex_);
  // The robot whose break point it is hears its own word. It may have gone on meanwhile.
  if (stop.robot == robot_ || !executive_.stop_with_team()) return;
  ++told_.orders;
  told_.team_stop = stop;
  log_info("stopped with the team by " + in_words(stop));
}

void BreakDesk::resume(const msg::Command& command) {
  const std::lock_guard lock(mutex_);
  ++told_.orders;
  log_info(command.author + " lets this robot go on");
  executive_.resume();
}

void BreakDesk::step(const msg::Command& command) {
  const std::lock_guard lock(mutex_);
  const Result<void> done = begin_step();
  if (done) told_.stepped_by = command.author;
  answer(command.id, command.author + " lets this robot go on until its next change of state",
         done);
}

/// Requires: mutex_ is locked.
Result<void> BreakDesk::begin_step() {
  if (!executive_.in_service()) return Error{robot_ + " is out of service: commission it first"};
  if (executive_.step()) return {};
  if (executive_.held_after_fault())
    return Error{robot_ + " is held after a fault, not at a break point: resume it first"};
  return Error{robot_ + " is held by " + held_by_ + ", not at a break point: resume it first"};
}

void BreakDesk::obey(const msg::BreakOrder& order) {
  const std::lock_guard lock(mutex_);
  answer(order.id, in_words(order), carry_out(order));
}

/// Notes the answer to an order. Requires: mutex_ is locked.
void BreakDesk::answer(const std::string& id, const std::string& what, const Result<void>& done) {
  keep_answer(id, done ? "" : done.error().message);
  log_info(done ? what : what + ": refused: " + done.error().message);
}

/// Requires: mutex_ is locked.
void BreakDesk::keep_answer(const std::string& id, const std::string& refused) {
  ++told_.orders;
  auto& answers = told_.answers;
  // A stranger may have sent the order first, without its signature.
  std::erase_if(answers, [&](const msg::BreakAnswer& known) { return known.id == id; });
  answers.push_back({id, refused});
  if (answers.size() > kAnswersKept) answers.erase(answers.begin());
}

void BreakDesk::refuse(const std::string& order_id, const OrderRefusal& refusal) {
  // The first answer to the order is the true one. Whoever sends the order again must not change
  // it.
  if (refusal.kind == OrderRefusal::Kind::kReplayed) return;
  const std::lock_guard lock(mutex_);
  auto& answers = told_.answers;
  if (std::ranges::find(answers, order_id, &msg::BreakAnswer::id) != answers.end()) return;
  // However many orders strangers send, the answers to others are still told.
  refused_ids_.push_back(order_id);
  if (refused_ids_.size() > kRefusalsKept) {
    std::erase_if(answers, [&](const msg::BreakAnswer& known) {
      return known.id == refused_ids_.front() && !known.refused.empty();
    });
    refused_ids_.pop_front();
  }
  keep_answer(order_id, with_advice(refusal));
}

Result<void> BreakDesk::carry_out(const msg::BreakOrder& order) {
  Breaks& breaks = executive_.breaks();
  if (order.order == "clear") return breaks.clear(), Result<void>{};
  if (order.order != "set" && order.order != "remove" && order.order != "let_through")
    return Error{"there is no order '" + order.order +
                 "': it must be set, remove, clear or let_through"};
  if (order.points.empty()) return Error{"the order names no break point"};
  if (order.points.size() > BreakTable::kMostPoints)
    return Error{"the order names " + std::to_string(order.points.size()) + " break points, and " +
                 std::to_string(BreakTable::kMostPoints) + " are the most"};
  if (order.order == "set") return set(order);
  if (order.order == "remove") return breaks.remove(changes_in(order));
  return breaks.let_through(changes_in(order), executive_.present_state());
}

Result<void> BreakDesk::set(const msg::BreakOrder& order) {
  std::vector<BreakPoint> points;
  for (const auto& point : order.points) {
    const auto kind = break_kind_of(point.kind);
    if (!kind)
      return Error{"there is no kind " + std::to_string(point.kind) +
                   " of break point: it must be " +
                   msg::choice_of(msg::BreakPoint_Constants::kAll)};
    points.push_back({{point.from_state, point.to_state}, *kind, order.author});
  }
  return executive_.breaks().set(points);
}

BreakDesk::Told BreakDesk::told() const {
  const std::lock_guard lock(mutex_);
  return told_;
}

std::string BreakDesk::held_by() const {
  const std::lock_guard lock(mutex_);
  return held_by_;
}

std::uint64_t BreakDesk::orders() const {
  const std::lock_guard lock(mutex_);
  return told_.orders;
}

}  // namespace galilean::robot
