// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/chain.h"

#include <nlohmann/json.hpp>

#include "bhdl/source/sha256.h"
#include "core/json_text.h"

namespace galilean::monitor::chain {
namespace {

// AUTOINCREMENT, so that the number of a row that was taken away from the end is not given again.
constexpr const char* kChainSchema = R"(
  CREATE TABLE IF NOT EXISTS chain(
    number INTEGER PRIMARY KEY AUTOINCREMENT, time_ns INTEGER NOT NULL, kind TEXT NOT NULL,
    subject TEXT NOT NULL, content TEXT NOT NULL, before TEXT NOT NULL, hash TEXT NOT NULL);
  CREATE INDEX IF NOT EXISTS chain_by_subject ON chain(kind, subject);
)";

}  // namespace

std::string hash_of(const Row& row) {
  return bhdl::sha256(std::to_string(row.number) + '\n' + std::to_string(row.time_ns) + '\n' +
                      row.kind + '\n' + row.subject + '\n' + row.content + '\n' + row.before);
}

void create_table(sqlite3* database) {
  sql::execute(database, kChainSchema);
}

void append(sqlite3* database, std::int64_t time_ns, const char* kind, const std::string& subject,
            const nlohmann::json& content) {
  Row row{.number = last_number(database) + 1,
          .time_ns = time_ns,
          .kind = kind,
          .subject = subject,
          .content = json_text(content),
          .before = kNoHash,
          .hash = {}};
  auto newest = select(database, "ORDER BY number DESC LIMIT 1");
  if (const auto last = next(newest)) row.before = last->hash;
  sql::Statement(database, "INSERT INTO chain VALUES(?, ?, ?, ?, ?, ?, ?)")
      .bind(row.number)
      .bind(row.time_ns)
      .bind(row.kind)
      .bind(row.subject)
      .bind(row.content)
      .bind(row.before)
      .bind(hash_of(row))
      .run();
}

std::int64_t last_number(sqlite3* database) {
  sql::Statement last(database,
                      "SELECT max((SELECT coalesce(max(number), 0) FROM chain), (SELECT "
                      "coalesce(max(seq), 0) FROM sqlite_sequence WHERE name = 'chain'))");
  return last.step() ? last.integer(0) : 0;
}

sql::Statement select(sqlite3* database, const std::string& condition) {
  return {database,
          "SELECT number, time_ns, kind, subject, content, before, hash FROM chain " + condition};
}

std::optional<Row> next(sql::Statement& rows) {
  if (!rows.step()) return std::nullopt;
  return Row{.number = rows.integer(0),
             .time_ns = rows.integer(1),
             .kind = rows.text(2),
             .subject = rows.text(3),
             .content = rows.text(4),
             .before = rows.text(5),
             .hash = rows.text(6)};
}

}  // namespace galilean::monitor::chain
