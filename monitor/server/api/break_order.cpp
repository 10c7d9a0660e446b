// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/break_order.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace galilean::monitor {
namespace {

using namespace std::string_view_literals;
namespace kinds = msg::BreakPoint_Constants;

/// As many as a robot has at most.
constexpr std::size_t kMostPoints = 32;
constexpr std::array kOrders{"set"sv, "remove"sv, "clear"sv, "let_through"sv};

msg::BreakPoint break_point(const nlohmann::json& item, RequestFields& request) {
  if (!item.is_object()) {
    request.refuse("Each of 'points' must be an object with 'from' or 'to'.");
    return {};
  }
  RequestFields fields(item);
  msg::BreakPoint point;
  point.from_state = fields.text("from");
  point.to_state = fields.text("to");
  const auto kind = msg::value_of(kinds::kAll, fields.text("kind", "stop"));
  if (!kind) fields.refuse("'kind' must be " + msg::choice_of(kinds::kAll) + ".");
  point.kind = kind.value_or(kinds::STOP);
  if (point.from_state.empty() && point.to_state.empty())
    fields.refuse("'from' or 'to' must name a state.");
  if (!fields.ok()) request.refuse("One of 'points' is wrong: " + fields.objection());
  return point;
}

void read_points(RequestFields& fields, msg::BreakOrder& order) {
  if (!fields.find("points")) return;
  const auto& points = fields.list("points");
  if (points.size() > kMostPoints)
    return fields.refuse("'points' must name " + std::to_string(kMostPoints) +
                         " at most: a robot has no more.");
  for (const auto& item : points) order.points.push_back(break_point(item, fields));
}

void check_order(RequestFields& fields, const msg::BreakOrder& order) {
  if (std::ranges::find(kOrders, order.order) == kOrders.end())
    return fields.refuse("'order' must be set, remove, clear or let_through.");
  const bool clears = order.order == "clear";
  if (clears && !order.points.empty())
    fields.refuse("'points' must be left out: clear takes all break points off.");
  if (!clears && order.points.empty()) fields.refuse("'points' must name one break point or more.");
}

}  // namespace

msg::BreakOrder break_order(RequestFields& fields) {
  msg::BreakOrder order;
  order.targets = fields.names("targets");
  order.author = fields.text("author");
  read_points(fields, order);
  order.order = fields.text("order");
  check_order(fields, order);
  return order;
}

}  // namespace galilean::monitor
