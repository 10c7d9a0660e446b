// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/break_words.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/plural.h"

namespace galilean::robot {
namespace {

namespace kinds = msg::BreakPoint_Constants;

struct KindOnWire {
  BreakKind kind;
  std::uint8_t value;
};
constexpr std::array kKindsOnWire{KindOnWire{BreakKind::kStop, kinds::STOP},
                                  KindOnWire{BreakKind::kStopTeam, kinds::STOP_TEAM},
                                  KindOnWire{BreakKind::kLock, kinds::LOCK}};
static_assert(kKindsOnWire.size() == std::size(kinds::kAll));

/// Returns the points of an order, such as "wander -> grab, on entering rest".
std::string list_of(const msg::BreakOrder& order) {
  if (order.points.size() > BreakTable::kMostPoints) return plural(order.points.size(), "place");
  std::string list;
  for (const auto& point : order.points)
    list += (list.empty() ? "" : ", ") + in_words(StateChange{point.from_state, point.to_state}) +
            (order.order == "set" ? " (" + msg::name_of(kinds::kAll, point.kind) + ")" : "");
  return list;
}

}  // namespace

std::uint8_t on_wire(BreakKind kind) noexcept {
  return std::ranges::find(kKindsOnWire, kind, &KindOnWire::kind)->value;
}

std::optional<BreakKind> break_kind_of(std::uint8_t value) noexcept {
  for (const auto& each : kKindsOnWire)
    if (each.value == value) return each.kind;
  return std::nullopt;
}

msg::BreakPoint on_wire(const BreakPoint& point) {
  return {point.at.from_state, point.at.to_state, on_wire(point.kind)};
}

std::string name_of(const BreakPoint& point) {
  return "break point " + in_words(point.at);
}

std::string in_words(const msg::TeamStop& stop) {
  return stop.robot + "'s break point " +
         change_words(stop.break_point.from_state, stop.break_point.to_state) + ", set by " +
         stop.author;
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
