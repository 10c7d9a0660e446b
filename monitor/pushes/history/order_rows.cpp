// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/order_rows.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/json_text.h"
#include "monitor/pushes/history/chain.h"

namespace galilean::monitor::rows {
namespace {

/// Returns the row's content as JSON. Throws if it is damaged.
nlohmann::json content_of(const chain::Row& row) {
  auto json = read_json(row.content);
  if (!json || !json.value().is_object())
    throw std::runtime_error("the history of pushes: row " + std::to_string(row.number) +
                             " is damaged; 'galilean programs verify' tells more");
  return std::move(json).value();
}

std::vector<OrderOutcome> outcomes_of(sqlite3* database, const std::string& order_id) {
  auto rows = chain::select(database, "WHERE kind = ? AND subject = ? ORDER BY number");
  rows.bind(chain::kOutcome).bind(order_id);
  std::vector<OrderOutcome> outcomes;
  while (const auto row = chain::next(rows)) {
    const auto content = content_of(*row);
    outcomes.push_back({.of = content.value("of", ""),
                        .outcome = content.value("outcome", ""),
                        .told_ns = row->time_ns});
  }
  return outcomes;
}

}  // namespace

void put_order(sqlite3* database, const OrderRecord& order, std::int64_t now_ns) {
  auto known = chain::select(database, "WHERE kind = ? AND subject = ? LIMIT 1");
  known.bind(chain::kOrder).bind(order.id);
  if (chain::next(known)) return;
  chain::append(database, now_ns, chain::kOrder, order.id,
                {{"ordered_ns", order.ordered_ns},
                 {"author", order.author},
                 {"kind", order.kind},
                 {"targets", order.targets},
                 {"detail", order.detail}});
}

void put_outcome(sqlite3* database, const std::string& order_id, const OrderOutcome& outcome) {
  chain::append(database, outcome.told_ns, chain::kOutcome, order_id,
                {{"of", outcome.of}, {"outcome", outcome.outcome}});
}

std::vector<OrderRecord> newest_orders(sqlite3* database, int most) {
  auto rows = chain::select(database, "WHERE kind = ? ORDER BY number DESC LIMIT ?");
  rows.bind(chain::kOrder).bind(static_cast<std::int64_t>(most));
  std::vector<OrderRecord> orders;
  while (const auto row = chain::next(rows)) {
    const auto content = content_of(*row);
    orders.push_back({.id = row->subject,
                      .ordered_ns = content.value("ordered_ns", std::int64_t{}),
                      .author = content.value("author", ""),
                      .kind = content.value("kind", ""),
                      .targets = content.value("targets", std::vector<std::string>()),
                      .detail = content.value("detail", ""),
                      .outcomes = outcomes_of(database, row->subject)});
  }
  return orders;
}

}  // namespace galilean::monitor::rows
