// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history.h"

#include <nlohmann/json.hpp>

#include "core/json_text.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/sql.h"

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
  CREATE TABLE IF NOT EXISTS progress(
    push_id TEXT PRIMARY KEY REFERENCES push(id), state TEXT NOT NULL, steps TEXT NOT NULL,
    trial TEXT NOT NULL) WITHOUT ROWID;
  UPDATE progress SET state = 'interrupted' WHERE state = 'running';
)";

/// What all questions for pushes have in common.
constexpr const char* kPushes =
    "SELECT id, pushed_ns, author, path, push.hash, targets, state, steps, trial FROM push "
    "JOIN program_file ON program_file.hash = push.hash AND position = 0 "
    "LEFT JOIN progress ON progress.push_id = push.id ";

std::string steps_text(const std::vector<SwapStep>& steps) {
  auto json = nlohmann::json::array();
  for (const auto& step : steps) json.push_back({step.name, step.state, step.detail});
  return json_text(json);
}

std::vector<SwapStep> steps_of(const std::string& text) {
  std::vector<SwapStep> steps;
  for (const auto& step : nlohmann::json::parse(text.empty() ? "[]" : text))
    steps.push_back({step.at(0), step.at(1), step.at(2)});
  return steps;
}

void put_progress(sqlite3* database, const std::string& push_id, const SwapProgress& progress) {
  sql::Statement(database, "INSERT OR REPLACE INTO progress VALUES(?, ?, ?, ?)")
      .bind(push_id)
      .bind(progress.state)
      .bind(steps_text(progress.steps))
      .bind(progress.trial_json)
      .run();
}

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

std::vector<PushRecord> records_of(sqlite3* database, sql::Statement& rows) {
  std::vector<PushRecord> records;
  while (rows.step())
    records.push_back({rows.text(0),
                       rows.integer(1),
                       rows.text(2),
                       rows.text(3),
                       rows.text(4),
                       nlohmann::json::parse(rows.text(5)).get<std::vector<std::string>>(),
                       {rows.text(6), steps_of(rows.text(7)), rows.text(8)},
                       answers_to(database, rows.text(0))});
  return records;
}

std::optional<PushRecord> one_of(std::vector<PushRecord> records) {
  if (records.empty()) return std::nullopt;
  return std::move(records.front());
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

void History::add(const msg::ProgramPush& push, const SwapProgress& progress) {
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
      .bind(json_text(push.targets))
      .run();
  put_progress(database_, push.id, progress);
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

void History::set_progress(const std::string& push_id, const SwapProgress& progress) {
  put_progress(database_, push_id, progress);
}

std::vector<PushRecord> History::pushes(int most) const {
  sql::Statement rows(database_, std::string(kPushes) + "ORDER BY pushed_ns DESC LIMIT ?");
  rows.bind(static_cast<std::int64_t>(most));
  return records_of(database_, rows);
}

std::optional<PushRecord> History::push(const std::string& id) const {
  sql::Statement rows(database_, std::string(kPushes) + "WHERE id = ?");
  rows.bind(id);
  return one_of(records_of(database_, rows));
}

std::optional<PushRecord> History::last_push_of(const std::string& hash) const {
  sql::Statement rows(database_,
                      std::string(kPushes) + "WHERE push.hash = ? ORDER BY pushed_ns DESC LIMIT 1");
  rows.bind(hash);
  return one_of(records_of(database_, rows));
}

std::optional<std::vector<bhdl::SourceFile>> History::program(const std::string& hash) const {
  // A hash is ASCII: all that begin so lie below what DEL follows.
  sql::Statement rows(database_,
                      "SELECT path, text, hash FROM program_file WHERE hash >= ? AND hash < ? "
                      "ORDER BY hash, position");
  rows.bind(hash).bind(hash + "\x7f");
  std::vector<bhdl::SourceFile> files;
  std::string found;
  while (rows.step()) {
    if (!found.empty() && found != rows.text(2)) return std::nullopt;
    found = rows.text(2);
    files.push_back({rows.text(0), rows.text(1)});
  }
  if (files.empty()) return std::nullopt;
  return files;
}

}  // namespace galilean::monitor
