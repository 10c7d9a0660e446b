// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "monitor/pushes/history/order_record.h"
#include "monitor/pushes/history/sql.h"

namespace galilean::monitor::rows {

// Reads and writes the chain's rows of orders that are no pushes. All functions throw
// std::runtime_error if the disk cannot be read or written.

/// Does nothing if there is an order of this id. Requires: a transaction is open.
void put_order(sqlite3* database, const OrderRecord& order, std::int64_t now_ns);
/// Requires: a transaction is open.
void put_outcome(sqlite3* database, const std::string& order_id, const OrderOutcome& outcome);
/// Adds a refused push as an order with its outcome. Does nothing if there is an order of this id.
/// Requires: a transaction is open.
void put_refused_push(sqlite3* database, const RefusedPush& refused, std::int64_t now_ns);
/// Returns nothing if no push of this id was refused.
[[nodiscard]] std::optional<RefusedPush> refused_push(sqlite3* database, const std::string& id);
/// Returns the newest orders, at most `most` of them, the newest first.
[[nodiscard]] std::vector<OrderRecord> newest_orders(sqlite3* database, int most);

}  // namespace galilean::monitor::rows
