// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/break_reason.h"

#include <algorithm>

#include "core/state_change.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

namespace stoppers = msg::Breaks_Constants;

const msg::Transition* transition_numbered(const Robot& robot, std::uint64_t number) {
  const auto found = std::ranges::find(robot.transitions, number, &msg::Transition::number);
  return found == robot.transitions.end() ? nullptr : &*found;
}

/// A robot that a fault holds says so among its problems.
std::string fault_reason(const msg::RobotState& state) {
  const auto says_why = [](const std::string& problem) { return problem.starts_with("held: "); };
  const auto found = std::ranges::find_if(state.problems, says_why);
  return state.held && found != state.problems.end() ? *found : std::string();
}

bool is_known(const msg::BreakPoint& point) {
  return !point.from_state.empty() || !point.to_state.empty();
}

std::string break_point_words(const msg::BreakPoint& point) {
  return is_known(point) ? "break point " + change_words(point.from_state, point.to_state)
                         : "a break point";
}

std::string reason_at_break_point(const msg::Transition* change, const msg::Breaks& breaks) {
  const auto& point = breaks.break_point;
  const auto place = change            ? place_words(change->from_state, change->to_state)
                     : is_known(point) ? place_words(point.from_state, point.to_state)
                                       : "at a break point";
  return "stopped " + place +
         (breaks.author.empty() ? "" : " (" + breaks.author + "'s break point)");
}

std::string stop_reason(const Robot& robot, const msg::Breaks& breaks) {
  const msg::Transition* change = transition_numbered(robot, breaks.stopped_at);
  if (breaks.stopped_by == stoppers::BREAK_POINT) return reason_at_break_point(change, breaks);
  if (breaks.stopped_by == stoppers::STEP)
    return change ? "stepped into " + change->to_state : "stopped after a step";
  return "stopped by " + stopper_words(breaks) +
         (breaks.author.empty() ? "" : ", set by " + breaks.author);
}

}  // namespace

bool waits_at_lock(const msg::Breaks& breaks) noexcept {
  return !breaks.waits_at_from.empty() || !breaks.waits_at_to.empty();
}

double lock_wait_s(const msg::Breaks& breaks, Duration since_told) noexcept {
  const auto waited_ns =
      wire::since_epoch_ns(breaks.stamp) - wire::since_epoch_ns(breaks.waits_since);
  return std::max(static_cast<double>(waited_ns) * 1e-9 + to_seconds(since_told), 0.0);
}

std::string stopper_words(const msg::Breaks& breaks) {
  switch (breaks.stopped_by) {
    case stoppers::NOTHING:
      return {};
    case stoppers::BREAK_POINT:
      return break_point_words(breaks.break_point);
    case stoppers::STEP:
      return "a step";
    case stoppers::TEAM:
      return breaks.break_robot + "'s " +
             (is_known(breaks.break_point) ? break_point_words(breaks.break_point) : "break point");
    default:
      return "a reason that this release does not know";
  }
}

std::string break_reason(const Robot& robot, Duration since_told) {
  if (robot.state)
    if (auto reason = fault_reason(*robot.state); !reason.empty()) return reason;
  if (!robot.breaks) return {};
  const msg::Breaks& breaks = *robot.breaks;
  if (breaks.stopped) return stop_reason(robot, breaks);
  if (waits_at_lock(breaks)) {
    const auto whole_s = static_cast<long>(lock_wait_s(breaks, since_told));
    return "waits at the lock " + change_words(breaks.waits_at_from, breaks.waits_at_to) + " for " +
           std::to_string(whole_s) + " s";
  }
  return breaks.stepping ? "goes on until its next change of state" : "";
}

}  // namespace galilean::monitor
