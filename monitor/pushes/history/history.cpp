// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history.h"

#include <fcntl.h>
#include <unistd.h>

#include "core/private_file.h"
#include "monitor/pushes/history/history_rows.h"
#include "monitor/pushes/history/push_messages.h"
#include "monitor/pushes/history/sql.h"

namespace galilean::monitor {
namespace {

/// Makes the database's file, because SQLite would let others read what it makes. Where this fails,
/// SQLite says why. The files that SQLite puts beside it get its mode, but an earlier release may
/// have left some.
void make_private_database(const std::filesystem::path& file) {
  (void)make_private_folder(file.parent_path());
  if (const auto made = open_private_file(file, O_WRONLY | O_EXCL)) close(made.value());
  for (const char* ending : {"", "-wal", "-shm"}) take_from_others(file.string() + ending);
}

}  // namespace

Result<std::unique_ptr<History>> History::open(const std::filesystem::path& file) try {
  make_private_database(file);
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<History> history(new History(database));
  if (opened != SQLITE_OK) sql::fail(database);
  sqlite3_busy_timeout(database, 2000);
  sql::execute(database, "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
  rows::create_tables(database);
  return history;
} catch (const std::exception& error) {
  return Error{std::string(error.what()) + " (" + file.string() +
               "); name a folder that can be written with --data DIR"};
}

History::~History() {
  sqlite3_close(database_);
}

Result<void> History::add(const msg::ProgramPush& announced, const Progress& progress) {
  msg::ProgramPush push = announced;
  push.hash = hash_of_files(announced);
  return sql::attempt([&] {
    sql::Transaction transaction(database_);
    rows::put_files(database_, push);
    rows::put_push(database_, push);
    rows::put_progress(database_, push.id, progress);
    transaction.commit();
  });
}

Result<void> History::add_reply(const std::string& push_id, const RobotReply& reply) {
  return sql::attempt([&] { rows::put_reply(database_, push_id, reply); });
}

Result<void> History::set_progress(const std::string& push_id, const Progress& progress) {
  return sql::attempt([&] { rows::put_progress(database_, push_id, progress); });
}

Result<std::vector<PushRecord>> History::pushes(int most) const {
  return sql::attempt([&] {
    auto found = rows::select_pushes(database_, "ORDER BY sequence DESC LIMIT ?");
    found.bind(static_cast<std::int64_t>(most));
    return rows::records_of(database_, found);
  });
}

Result<std::optional<PushRecord>> History::push(const std::string& id) const {
  return sql::attempt([&] {
    auto found = rows::select_pushes(database_, "WHERE id = ?");
    found.bind(id);
    return rows::record_of(database_, found);
  });
}

Result<std::optional<PushRecord>> History::last_push_of(const std::string& hash) const {
  return sql::attempt([&] {
    auto found =
        rows::select_pushes(database_, "WHERE push.hash = ? ORDER BY sequence DESC LIMIT 1");
    found.bind(hash);
    return rows::record_of(database_, found);
  });
}

Result<std::optional<std::vector<bhdl::SourceFile>>> History::program(
    const std::string& hash) const {
  return sql::attempt([&] { return rows::files_of(database_, hash); });
}

}  // namespace galilean::monitor
