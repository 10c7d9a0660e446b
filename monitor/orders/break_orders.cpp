// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/break_orders.h"

#include <unistd.h>

#include "core/account.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {

std::string BreakOrders::give(msg::BreakOrder order) {
  const std::int64_t now_ns = wire::wall_clock_ns();
  order.stamp = wire::ros_time(now_ns);
  order.id = std::to_string(getpid()) + "-breaks-" + std::to_string(now_ns) + "-" +
             std::to_string(++given_);
  order.author = user_name();
  return writer_.write(order) ? order.id : std::string();
}

}  // namespace galilean::monitor
