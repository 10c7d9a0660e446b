// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/order_rows.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/json_text.h"
#include "monitor/pushes/history/chain.h"

namespace galilean::monitor::rows {
namespace {

// How a refused push is told. The words in the file never change.
constexpr const char* kPushKind = "push";
constexpr const char* kRefuser = "monitor";
constexpr std::string_view kRefused = "refused: ";

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

bool has_order(sqlite3* database, const std::string& id) {
  auto known = chain::select(database, "WHERE kind = ? AND subject = ? LIMIT 1");
  known.bind(chain::kOrder).bind(id);
  return chain::next(known).has_value();
}

}  // namespace

void put_order(sqlite3* database, const OrderRecord& order, std::int64_t now_ns) {
  if (has_order(database, order.id)) return;
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

void put_refused_push(sqlite3* database, const RefusedPush& refused, std::int64_t now_ns) {
  if (has_order(database, refused.id)) return;
  chain::append(database, now_ns, chain::kOrder, refused.id,
                {{"ordered_ns", refused.ordered_ns},
                 {"author", refused.author},
                 {"kind", kPushKind},
                 {"targets", refused.targets},
                 {"detail", refused.program},
                 {"reason", refused.reason}});
  put_outcome(
      database, refused.id,
      {.of = kRefuser, .outcome = std::string(kRefused) + refused.message, .told_ns = now_ns});
}

std::optional<RefusedPush> refused_push(sqlite3* database, const std::string& id) {
  auto rows = chain::select(database, "WHERE kind = ? AND subject = ? LIMIT 1");
  rows.bind(chain::kOrder).bind(id);
  const auto row = chain::next(rows);
  if (!row) return std::nullopt;
  const auto content = content_of(*row);
  if (content.value("kind", "") != kPushKind) return std::nullopt;
  RefusedPush refused{.id = id,
                      .ordered_ns = content.value("ordered_ns", std::int64_t{}),
                      .author = content.value("author", ""),
                      .targets = content.value("targets", std::vector<std::string>()),
                      .program = content.value("detail", ""),
                      .reason = content.value("reason", ""),
                      .message = {}};
  for (const auto& each : outcomes_of(database, id))
    if (each.outcome.starts_with(kRefused)) refused.message = each.outcome.substr(kRefused.size());
  return refused;
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
