// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/break_words.h"

#include <algorithm>

#include "core/state_change.h"
#include "core/wire/ros_time.h"
#include "monitor/team/break_reason.h"

namespace galilean::monitor {
namespace {

namespace kinds = msg::BreakPoint_Constants;

/// Returns "3 s". Both stamps are of one robot's clock.
std::string seconds_between(const msg::Time& from, const msg::Time& to) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t between_ns = wire::since_epoch_ns(to) - wire::since_epoch_ns(from);
  return std::to_string(std::max<std::int64_t>(between_ns, 0) / kSecond_ns) + " s";
}

std::string list_of(const std::vector<msg::BreakPoint>& points,
                    std::string (*words)(const msg::BreakPoint&)) {
  std::string list;
  for (const auto& point : points) list += (list.empty() ? "" : ", ") + words(point);
  return list;
}

}  // namespace

msg::BreakPoint place_in(std::string_view text) {
  const auto colon = text.find(':');
  msg::BreakPoint place;
  if (colon != text.npos) place.from_state = text.substr(0, colon);
  place.to_state = colon == text.npos ? text : text.substr(colon + 1);
  return place;
}

std::string place_of(const msg::BreakPoint& point) {
  return place_words(point.from_state, point.to_state);
}

std::string rule_of(const msg::BreakPoint& point) {
  switch (point.kind) {
    case kinds::STOP:
      return "stops " + place_of(point);
    case kinds::STOP_TEAM:
      return "stops the team " + place_of(point);
    case kinds::LOCK:
      return "is locked " + place_of(point);
    default:
      return "has a break point of the unknown kind " + std::to_string(point.kind) + " " +
             place_of(point);
  }
}

std::string reason_of(const msg::Breaks& told) {
  if (!told.stopped) return "";
  return stopper_words(told) + (told.author.empty() ? "" : " (" + told.author + ")");
}

std::vector<std::string> lines_of(const msg::Breaks& told) {
  std::vector<std::string> lines;
  for (const auto& point : told.points) lines.push_back(rule_of(point));
  if (lines.empty()) lines.emplace_back("has no break points");
  if (told.stopped) lines.push_back("was stopped by " + reason_of(told));
  if (told.stepping) lines.emplace_back("goes on until its next change of state");
  if (!told.waits_at_to.empty())
    lines.push_back("has waited at the lock " + change_words(told.waits_at_from, told.waits_at_to) +
                    " for " + seconds_between(told.waits_since, told.stamp));
  return lines;
}

std::string effect_of(const msg::BreakOrder& order) {
  if (order.order == "set") return list_of(order.points, rule_of);
  if (order.order == "remove") return "no longer stops or waits " + list_of(order.points, place_of);
  if (order.order == "clear") return "has no break points";
  return "opens the lock once " + list_of(order.points, place_of);
}

std::vector<std::string> unknown_states(const msg::BreakOrder& order, const msg::Program& program) {
  std::vector<std::string> unknown;
  for (const auto& point : order.points)
    for (const auto& name : {point.from_state, point.to_state})
      if (!name.empty() &&
          std::ranges::find(program.states, name, &msg::MachineState::name) == program.states.end())
        unknown.push_back(name);
  return unknown;
}

}  // namespace galilean::monitor
