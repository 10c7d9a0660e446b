// SPDX-License-Identifier: BSD-3-Clause
// Reads a row of the history of pushes whose texts are random, as a damaged or a foreign file has
// them. The input is cut at its line ends: targets, state, steps, trial, status, message. What is
// read can be told as JSON, and is the same when it was written again. What is not is an error.
#include <sqlite3.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/json_text.h"
#include "monitor/pushes/history/history_rows.h"
#include "monitor/pushes/history/json.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;
using bhdl::must;

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, Close>;

using Texts = std::array<std::string_view, 6>;

Texts texts_of(std::string_view rest) {
  Texts texts;
  for (auto& text : texts) {
    const auto end = rest.find('\n');
    text = rest.substr(0, end);
    rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
  }
  return texts;
}

Database open_empty() {
  sqlite3* opened = nullptr;
  must(sqlite3_open(":memory:", &opened) == SQLITE_OK, "there is memory for a history");
  Database database(opened);
  rows::create_tables(opened);
  return database;
}

/// Writes one push with these texts, past all that checks them.
void put(sqlite3* database, const Texts& texts) {
  for (const char* table : {"answer", "progress", "push_sequence", "push", "program_file"})
    sql::execute(database, (std::string("DELETE FROM ") + table).c_str());
  sql::execute(database, "INSERT INTO program_file VALUES('h', 0, 'a.bhdl', '')");
  sql::Statement(database, "INSERT INTO push VALUES('1', 1, 'Anna', 'h', ?)").bind(texts[0]).run();
  sql::execute(database, "INSERT INTO push_sequence(push_id) VALUES('1')");
  sql::Statement(database, "INSERT INTO progress VALUES('1', ?, ?, ?)")
      .bind(texts[1])
      .bind(texts[2])
      .bind(texts[3])
      .run();
  sql::Statement(database, "INSERT INTO answer VALUES('1', 'io', ?, ?, '', 1.5)")
      .bind(texts[4])
      .bind(texts[5])
      .run();
}

Result<std::vector<PushRecord>> read_all(sqlite3* database) {
  return sql::attempt([&] {
    auto pushes = rows::select_pushes(database, "ORDER BY sequence");
    return rows::records_of(database, pushes);
  });
}

std::string told(const PushRecord& record) {
  auto text = json_text(to_json(record));
  must(nlohmann::json::accept(text), "a push can be told as JSON");
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Database database = open_empty();
  put(database.get(), texts_of({reinterpret_cast<const char*>(data), size}));
  const auto records = read_all(database.get());
  if (!records) {
    must(!records.error().message.empty(), "an error says something");
    return 0;
  }
  must(records.value().size() == 1, "the push is read");
  const auto& record = records.value().front();
  must(record.replies.size() == 1 && record.progress.steps.size() <= size, "a push has its rows");
  rows::put_progress(database.get(), record.id, record.progress);
  for (const auto& reply : record.replies) rows::put_reply(database.get(), record.id, reply);
  const auto again = read_all(database.get());
  must(again.ok() && again.value().size() == 1, "what was written is read");
  must(told(again.value().front()) == told(record), "what is read is what was written");
  return 0;
}
