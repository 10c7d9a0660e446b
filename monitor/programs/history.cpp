#include "monitor/programs/history.h"

#include <nlohmann/json.hpp>

#include "core/wire/topics.h"
#include "monitor/programs/sql.h"

namespace galilean::monitor {
namespace {

constexpr const char* kSchema = R"(
  CREATE TABLE IF NOT EXISTS program_file(
    hash TEXT NOT NULL, position INTEGER NOT NULL, path TEXT NOT NULL, text TEXT NOT NULL,
    PRIMARY KEY(hash, position)) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS push(
    id TEXT PRIMARY KEY, pushed_ns INTEGER NOT NULL, author TEXT NOT NULL, hash TEXT NOT NULL,
    targets TEXT NOT NULL) WITHOUT ROWID;
  CREATE INDEX IF NOT EXISTS push_by_time ON push(pushed_ns);
  CREATE TABLE IF NOT EXISTS answer(
    push_id TEXT NOT NULL REFERENCES push(id), robot TEXT NOT NULL, status TEXT NOT NULL,
    message TEXT NOT NULL, running_hash TEXT NOT NULL, latency_ms REAL NOT NULL,
    PRIMARY KEY(push_id, robot)) WITHOUT ROWID;
)";

std::vector<PushAnswer> answers_to(sqlite3* database, const std::string& push_id) {
  sql::Statement rows(database,
                      "SELECT robot, status, message, running_hash, latency_ms FROM answer "
                      "WHERE push_id = ? ORDER BY robot");
  rows.bind(push_id);
  std::vector<PushAnswer> answers;
  while (rows.step()) {
    PushAnswer& answer = answers.emplace_back();
    answer.robot = answer.reply.robot = rows.text(0);
    answer.status = rows.text(1);
    answer.reply.message = rows.text(2);
    answer.reply.running_hash = rows.text(3);
    answer.latency_ms = rows.number(4);
  }
  return answers;
}

}  // namespace

Result<std::unique_ptr<History>> History::open(const std::filesystem::path& file) try {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<History> history(new History(database));
  if (opened != SQLITE_OK) sql::fail(database);
  sqlite3_busy_timeout(database, 2000);
  sql::execute(database, "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
  sql::execute(database, kSchema);
  return history;
} catch (const std::exception& error) {
  return Error{std::string(error.what()) + " (" + file.string() +
               "); name a folder that can be written with --data DIR"};
}

History::~History() {
  sqlite3_close(database_);
}

void History::add(const msg::ProgramPush& push) {
  sql::Transaction transaction(database_);
  for (std::size_t i = 0; i < push.files.size(); ++i)
    sql::Statement(database_, "INSERT OR IGNORE INTO program_file VALUES(?, ?, ?, ?)")
        .bind(push.hash)
        .bind(static_cast<std::int64_t>(i))
        .bind(push.files[i].path)
        .bind(push.files[i].text)
        .run();
  sql::Statement(database_, "INSERT OR IGNORE INTO push VALUES(?, ?, ?, ?, ?)")
      .bind(push.id)
      .bind(wire::since_epoch_ns(push.stamp))
      .bind(push.author)
      .bind(push.hash)
      .bind(nlohmann::json(push.targets).dump())
      .run();
  transaction.commit();
}

void History::add_answer(const std::string& push_id, const PushAnswer& answer) {
  sql::Statement(database_, "INSERT OR REPLACE INTO answer VALUES(?, ?, ?, ?, ?, ?)")
      .bind(push_id)
      .bind(answer.robot)
      .bind(answer.status)
      .bind(answer.reply.message)
      .bind(answer.reply.running_hash)
      .bind(answer.latency_ms)
      .run();
}

std::vector<PushRecord> History::pushes(int most) const {
  sql::Statement rows(database_,
                      "SELECT id, pushed_ns, author, path, push.hash, targets FROM push "
                      "JOIN program_file ON program_file.hash = push.hash AND position = 0 "
                      "ORDER BY pushed_ns DESC LIMIT ?");
  rows.bind(static_cast<std::int64_t>(most));
  std::vector<PushRecord> records;
  while (rows.step())
    records.push_back({rows.text(0), rows.integer(1), rows.text(2), rows.text(3), rows.text(4),
                       nlohmann::json::parse(rows.text(5)).get<std::vector<std::string>>(),
                       answers_to(database_, rows.text(0))});
  return records;
}

std::optional<std::vector<bhdl::SourceFile>> History::program(const std::string& hash) const {
  sql::Statement rows(database_,
                      "SELECT path, text FROM program_file WHERE hash = ? ORDER BY position");
  rows.bind(hash);
  std::vector<bhdl::SourceFile> files;
  while (rows.step()) files.push_back({rows.text(0), rows.text(1)});
  if (files.empty()) return std::nullopt;
  return files;
}

}  // namespace galilean::monitor
