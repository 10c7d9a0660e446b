// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/break_reason.h"

#include <algorithm>
#include <string_view>

#include "core/state_change.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

/// What a robot says of the end of a step, and how it begins the name of one of its break points.
constexpr std::string_view kStep = "a step";
constexpr std::string_view kBreakPoint = "break point ";

const msg::Transition* transition_numbered(const Robot& robot, std::uint64_t number) {
  const auto found = std::ranges::find(robot.transitions, number, &msg::Transition::number);
  return found == robot.transitions.end() ? nullptr : &*found;
}

/// Returns where the robot's own break point is, by its name: "at wander -> grab", "on entering
/// grab".
std::string place_in(std::string_view name) {
  if (!name.starts_with(kBreakPoint)) return "at " + std::string(name);
  name.remove_prefix(kBreakPoint.size());
  const bool names_both = name.find(" -> ") != name.npos;
  return (names_both ? "at " : "") + std::string(name);
}

std::string stop_reason(const Robot& robot, const msg::Breaks& breaks) {
  const msg::Transition* change = transition_numbered(robot, breaks.stopped_at);
  if (breaks.stopped_by == kStep)
    return change ? "stepped into " + change->to_state : "stopped after a step";
  if (breaks.stopped_at == 0)
    return "stopped by " + breaks.stopped_by +
           (breaks.author.empty() ? "" : ", set by " + breaks.author);
  const auto place =
      change ? place_words(change->from_state, change->to_state) : place_in(breaks.stopped_by);
  return "stopped " + place +
         (breaks.author.empty() ? "" : " (" + breaks.author + "'s break point)");
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

std::string break_reason(const Robot& robot, Duration since_told) {
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
