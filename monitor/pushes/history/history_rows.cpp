// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history_rows.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "bhdl/source/sha256.h"
#include "core/json_text.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor::rows {
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
  CREATE TABLE IF NOT EXISTS push_sequence(
    sequence INTEGER PRIMARY KEY AUTOINCREMENT, push_id TEXT NOT NULL UNIQUE REFERENCES push(id));
  CREATE TABLE IF NOT EXISTS told_later(
    push_id TEXT PRIMARY KEY REFERENCES push(id), told_ns INTEGER NOT NULL) WITHOUT ROWID;
)";

/// Numbers the pushes that an earlier release wrote. Nothing is known of their order but their
/// time.
constexpr const char* kNumberThePast = R"(
  INSERT OR IGNORE INTO push_sequence(push_id)
    SELECT id FROM push WHERE id NOT IN (SELECT push_id FROM push_sequence)
    ORDER BY pushed_ns, id;
)";

std::string steps_text(const std::vector<Step>& steps) {
  auto json = nlohmann::json::array();
  for (const auto& step : steps)
    json.push_back({to_text(step.kind), to_text(step.state), step.detail});
  return json_text(json);
}

/// Throws if the stored text is damaged.
nlohmann::json stored(const std::string& text) {
  auto json = read_json(text);
  if (!json) throw std::runtime_error(json.error().message);
  return std::move(json).value();
}

std::vector<Step> steps_of(const std::string& text) {
  std::vector<Step> steps;
  for (const auto& step : stored(text.empty() ? "[]" : text)) {
    const auto kind = step_kind_of(step.at(0).get<std::string>());
    const auto state = step_state_of(step.at(1).get<std::string>());
    if (kind && state) steps.push_back({*kind, *state, step.at(2)});
  }
  return steps;
}

/// Reads the columns that begin with `first`: state, steps, trial and told_ns.
Progress progress_of(const sql::Statement& row, int first) {
  Progress progress{.state = push_state_of(row.text(first)).value_or(PushState::kForeign),
                    .steps = steps_of(row.text(first + 1)),
                    .trial = nullptr,
                    .told_ns = row.integer(first + 3)};
  if (auto figures = read_json(row.text(first + 2))) progress.trial = std::move(figures).value();
  return progress;
}

std::vector<RobotReply> replies_to(sqlite3* database, const std::string& push_id) {
  sql::Statement rows(database,
                      "SELECT robot, status, message, running_hash, latency_ms FROM answer "
                      "WHERE push_id = ? ORDER BY robot");
  rows.bind(push_id);
  std::vector<RobotReply> replies;
  while (rows.step()) {
    RobotReply& reply = replies.emplace_back();
    reply.robot = reply.reply.robot = rows.text(0);
    reply.status = reply_status_of(rows.text(1)).value_or(ReplyStatus::kUnknown);
    reply.reply.message = rows.text(2);
    reply.reply.running_hash = rows.text(3);
    reply.latency_ms = rows.number(4);
  }
  return replies;
}

}  // namespace

void create_tables(sqlite3* database) {
  sql::execute(database, kSchema);
  sql::execute(database, kNumberThePast);
}

void put_files(sqlite3* database, const msg::ProgramPush& push) {
  const auto hash = hash_of_files(push);
  for (std::size_t i = 0; i < push.files.size(); ++i)
    sql::Statement(database, "INSERT OR IGNORE INTO program_file VALUES(?, ?, ?, ?)")
        .bind(hash)
        .bind(static_cast<std::int64_t>(i))
        .bind(push.files[i].path)
        .bind(push.files[i].text)
        .run();
}

bool put_push(sqlite3* database, const msg::ProgramPush& push) {
  sql::Statement(database, "INSERT OR IGNORE INTO push VALUES(?, ?, ?, ?, ?)")
      .bind(push.id)
      .bind(wire::since_epoch_ns(push.stamp))
      .bind(push.author)
      .bind(hash_of_files(push))
      .bind(json_text(push.targets))
      .run();
  if (sqlite3_changes(database) == 0) return false;
  sql::Statement(database, "INSERT OR IGNORE INTO push_sequence(push_id) VALUES(?)")
      .bind(push.id)
      .run();
  return true;
}

void put_progress(sqlite3* database, const std::string& push_id, const Progress& progress) {
  sql::Statement(database, "INSERT OR REPLACE INTO progress VALUES(?, ?, ?, ?)")
      .bind(push_id)
      .bind(to_text(progress.state))
      .bind(steps_text(progress.steps))
      .bind(progress.trial.is_null() ? std::string() : json_text(progress.trial))
      .run();
  if (progress.told_ns == 0) return;
  sql::Statement(database, "INSERT OR REPLACE INTO told_later VALUES(?, ?)")
      .bind(push_id)
      .bind(progress.told_ns)
      .run();
}

void put_reply(sqlite3* database, const std::string& push_id, const RobotReply& reply) {
  sql::Statement(database, "INSERT OR REPLACE INTO answer VALUES(?, ?, ?, ?, ?, ?)")
      .bind(push_id)
      .bind(reply.robot)
      .bind(to_text(reply.status))
      .bind(reply.reply.message)
      .bind(reply.reply.running_hash)
      .bind(reply.latency_ms)
      .run();
}

void set_state(sqlite3* database, const std::string& push_id, PushState state) {
  sql::Statement(database, "UPDATE progress SET state = ? WHERE push_id = ?")
      .bind(to_text(state))
      .bind(push_id)
      .run();
}

std::vector<std::string> in_state(sqlite3* database, PushState state) {
  sql::Statement rows(database, "SELECT push_id FROM progress WHERE state = ?");
  rows.bind(to_text(state));
  std::vector<std::string> ids;
  while (rows.step()) ids.push_back(rows.text(0));
  return ids;
}

sql::Statement select_pushes(sqlite3* database, const std::string& condition) {
  return {database,
          "SELECT id, pushed_ns, author, path, push.hash, targets, state, steps, trial, told_ns "
          "FROM push "
          "JOIN push_sequence ON push_sequence.push_id = push.id "
          "LEFT JOIN program_file ON program_file.hash = push.hash AND position = 0 "
          "LEFT JOIN progress ON progress.push_id = push.id "
          "LEFT JOIN told_later ON told_later.push_id = push.id " +
              condition};
}

std::vector<PushRecord> records_of(sqlite3* database, sql::Statement& rows) {
  std::vector<PushRecord> records;
  while (rows.step())
    records.push_back({.id = rows.text(0),
                       .pushed_ns = rows.integer(1),
                       .author = rows.text(2),
                       .program = rows.text(3),
                       .hash = rows.text(4),
                       .targets = stored(rows.text(5)).get<std::vector<std::string>>(),
                       .progress = progress_of(rows, 6),
                       .replies = replies_to(database, rows.text(0))});
  return records;
}

std::optional<PushRecord> record_of(sqlite3* database, sql::Statement& rows) {
  auto records = records_of(database, rows);
  if (records.empty()) return std::nullopt;
  return std::move(records.front());
}

std::optional<std::vector<bhdl::SourceFile>> files_of(sqlite3* database, const std::string& hash) {
  // Hashes are hexadecimal, so all that begin with `hash` sort before `hash` followed by DEL.
  sql::Statement rows(database,
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
  if (bhdl::program_hash(files) != found)
    throw std::runtime_error(
        "the history of pushes: the text that is kept as " + found +
        " is another program's: push the program from its file; 'galilean programs "
        "verify' tells more");
  return files;
}

}  // namespace galilean::monitor::rows
