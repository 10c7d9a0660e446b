// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/break_words.h"

#include <array>

#include "core/plural.h"

namespace galilean::robot {
namespace {

struct KindName {
  BreakKind kind;
  std::string_view name;
};
constexpr std::array kKindNames{KindName{BreakKind::kStop, "stop"},
                                KindName{BreakKind::kStopTeam, "stop_team"},
                                KindName{BreakKind::kLock, "lock"}};

/// Returns the points of an order, such as "wander -> grab, on entering rest".
std::string list_of(const msg::BreakOrder& order) {
  if (order.points.size() > BreakTable::kMostPoints) return plural(order.points.size(), "place");
  std::string list;
  for (const auto& point : order.points)
    list += (list.empty() ? "" : ", ") + in_words(StateChange{point.from_state, point.to_state}) +
            (order.order == "set" ? " (" + point.kind + ")" : "");
  return list;
}

}  // namespace

std::string_view to_string(BreakKind kind) noexcept {
  for (const auto& each : kKindNames)
    if (each.kind == kind) return each.name;
  return "";
}

std::optional<BreakKind> break_kind_named(std::string_view name) noexcept {
  for (const auto& each : kKindNames)
    if (each.name == name) return each.kind;
  return std::nullopt;
}

std::string name_of(const BreakPoint& point) {
  return "break point " + in_words(point.at);
}

std::string in_words(const msg::BreakOrder& order) {
  const std::string& who = order.author;
  if (order.order == "set") return who + " sets break points: " + list_of(order);
  if (order.order == "remove") return who + " takes break points off: " + list_of(order);
  if (order.order == "clear") return who + " takes all break points off";
  if (order.order == "let_through") return who + " lets through once: " + list_of(order);
  return who + " orders '" + order.order + "'";
}

}  // namespace galilean::robot
