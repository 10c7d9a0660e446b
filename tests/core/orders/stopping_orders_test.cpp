// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/stopping_orders.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

namespace kinds = msg::Command_Constants;
namespace points = msg::BreakPoint_Constants;

TEST(StoppingOrders, OfAllCommandsTwoOnlyStop) {
  for (int kind = 0; kind <= UINT8_MAX; ++kind) {
    msg::Command command;
    command.kind = static_cast<std::uint8_t>(kind);
    const bool stops = kind == kinds::HOLD || kind == kinds::DECOMMISSION;
    EXPECT_EQ(only_stops(command), stops) << kind;
  }
}

TEST(StoppingOrders, OfAllOrdersAboutBreakPointsThoseThatSetOnesThatStop) {
  for (const std::string order : {"set", "remove", "clear", "let_through", "", "SET"})
    for (int kind = 0; kind <= UINT8_MAX; ++kind) {
      msg::BreakOrder given;
      given.order = order;
      given.points = {{"", "grab", points::STOP}, {"", "rest", static_cast<std::uint8_t>(kind)}};
      const bool stops = kind == points::STOP || kind == points::STOP_TEAM;
      EXPECT_EQ(only_stops(given), order == "set" && stops) << order << ' ' << kind;
    }
}

}  // namespace
}  // namespace galilean
