// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "monitor/pushes/history/sql.h"

namespace galilean::monitor::chain {

// The chain is the history's one list of all that happened, in its order. Rows are only added. Each
// holds the SHA-256 of the row before it and of its own content, so that a row that was changed or
// taken away is found. All functions throw std::runtime_error if the disk cannot be read or
// written.

/// What a row tells of. The words in the file never change.
inline constexpr const char* kAdopted = "adopted";    ///< rows that are older than the chain follow
inline constexpr const char* kPush = "push";          ///< a push was ordered
inline constexpr const char* kReply = "reply";        ///< what a robot said to a push
inline constexpr const char* kProgress = "progress";  ///< how far a push came
inline constexpr const char* kOrder = "order";        ///< an order other than a push
inline constexpr const char* kOutcome = "outcome";    ///< what became of such an order

/// What stands before the first row's hash.
inline constexpr const char* kNoHash =
    "0000000000000000000000000000000000000000000000000000000000000000";

struct Row {
  std::int64_t number = 0;   ///< 1, 2, 3 …
  std::int64_t time_ns = 0;  ///< since the Unix epoch, when the row was written
  std::string kind;
  std::string subject;  ///< the id of the push or the order; may be empty
  std::string content;  ///< JSON
  std::string before;   ///< the hash of the row before it
  std::string hash;
};

/// Returns the hash that the row must have: SHA-256 over its other members in their order, each but
/// the last followed by a line feed.
[[nodiscard]] std::string hash_of(const Row& row);

/// Makes the table if it is missing.
void create_table(sqlite3* database);
/// Adds a row. Requires: a transaction is open.
void append(sqlite3* database, std::int64_t time_ns, const char* kind, const std::string& subject,
            const nlohmann::json& content);
/// Returns the highest number that a row ever had, also one that was taken away; 0: none.
[[nodiscard]] std::int64_t last_number(sqlite3* database);

/// Returns a query for rows that ends with `condition`. The caller binds its parameters.
[[nodiscard]] sql::Statement select(sqlite3* database, const std::string& condition);
/// Returns the next row of such a query; nothing if there are no more.
[[nodiscard]] std::optional<Row> next(sql::Statement& rows);

}  // namespace galilean::monitor::chain
