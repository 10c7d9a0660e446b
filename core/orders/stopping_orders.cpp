// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/stopping_orders.h"

#include <algorithm>

namespace galilean {

bool only_stops(const msg::Command& command) noexcept {
  return command.kind == msg::Command_Constants::HOLD ||
         command.kind == msg::Command_Constants::DECOMMISSION;
}

bool only_stops(const msg::BreakOrder& order) noexcept {
  return order.order == "set" &&
         std::ranges::all_of(order.points, [](const msg::BreakPoint& point) {
           return point.kind == msg::BreakPoint_Constants::STOP ||
                  point.kind == msg::BreakPoint_Constants::STOP_TEAM;
         });
}

}  // namespace galilean
