// SPDX-License-Identifier: BSD-3-Clause
// How an executive changes its state, and where it stops between states.
#include "robot/executive/executive.h"

#include <algorithm>

#include "robot/executive/sequencer.h"

namespace galilean::robot {

void Executive::sequence() noexcept {
  if (!current_program()) return;
  const auto condition = condition_that_fires();
  if (!condition) return;
  const RunningCondition& fired = current().conditions[*condition];
  Event change = event(Event::Kind::kTransition);
  change.condition = *condition;
  change.from_state = current_program()->state;
  change.tested = test_all(current(), tick_.now);
  const std::string_view left = state_name();
  fire(fired, tick_.now);
  enter(fired.new_state);
  note_transition(change, left);
}

/// Passes over conditions that are locked, as if they did not hold.
std::optional<std::uint32_t> Executive::condition_that_fires() noexcept {
  std::uint32_t waiting = Event::kNone;
  const auto fires = first_that_fires(current(), tick_.now, [&](std::uint32_t condition) {
    if (!is_locked(condition)) return true;
    waiting = std::min(waiting, condition);
    return false;
  });
  standstill_.wait.note(fires ? Event::kNone : waiting, tick_.now);
  return fires;
}

bool Executive::is_locked(std::uint32_t condition) const noexcept {
  const std::uint32_t new_state = current().conditions[condition].new_state;
  return breaks_.is_locked(state_name(), program()->text().states[new_state].name);
}

void Executive::note_transition(Event change, std::string_view from_state) noexcept {
  change.to_state = current_program()->state;
  change.number = ++transitions_;
  state_changed_ = true;
  succession_.probation().note_transition(tick_.now);
  stop_at(change, from_state);
  emit(change);
}

/// Stops the robot if a break point says so, or a step ends here. A robot that stands already stays
/// as it is, and one that is out of service stops nobody. The motors stand still in this tick,
/// because schemas act after it. An operator's order that comes in this tick counts from the next
/// one on, and is stronger.
void Executive::stop_at(Event& change, std::string_view from_state) noexcept {
  breaks_.end_passes();
  const BreakPoint* point =
      orders_.in_service ? breaks_.stop_at(from_state, state_name()) : nullptr;
  if (point ? !lets_drive(hold_) : hold_ != Hold::kStepping) return;
  static_cast<void>(point ? holding_.stop(Hold::kBreakPoint) : holding_.end_step());
  hold_ = point ? Hold::kBreakPoint : Hold::kStepEnd;
  change.stopped_by = hold_;
  change.break_point = point ? point->number : 0;
  standstill_.stopped_at = change.number;
  standstill_.break_point = change.break_point;
}

std::string Executive::present_state() const {
  const Whereabouts where = where_.load();
  const auto found = description(where.program);
  return found ? found->program.states.at(where.state).name : "";
}

Standstill Executive::standstill() const noexcept {
  Standstill now = standstill_;
  now.hold = hold_;
  return now;
}

}  // namespace galilean::robot
