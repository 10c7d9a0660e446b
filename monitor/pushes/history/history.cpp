// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/private_file.h"
#include "monitor/pushes/history/adoption.h"
#include "monitor/pushes/history/chain.h"
#include "monitor/pushes/history/history_rows.h"
#include "monitor/pushes/history/order_rows.h"
#include "monitor/pushes/history/sql.h"
#include "monitor/pushes/history/told_later.h"
#include "monitor/pushes/history/told_rows.h"

namespace galilean::monitor {
namespace {

constexpr const char* kTrialSchema =
    "CREATE TABLE IF NOT EXISTS disk_trial(number INTEGER PRIMARY KEY, time_ns INTEGER NOT NULL)";

/// Writes the folder's list of files to the disk, so that a file that was made is found again.
void sync_folder(const std::filesystem::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  (void)fsync(opened);
  ::close(opened);
}

std::string megabytes(std::uintmax_t bytes) {
  return std::to_string(bytes >> 20) + " MB";
}

/// Makes the database's file, because SQLite would let others read what it makes. Where this fails,
/// SQLite says why. The files that SQLite puts beside it get its mode, but an earlier release may
/// have left some.
void make_private_database(const std::filesystem::path& file) {
  (void)make_private_folder(file.parent_path());
  if (const auto made = open_private_file(file, O_WRONLY | O_EXCL)) close(made.value());
  for (const char* ending : {"", "-wal", "-shm"}) take_from_others(file.string() + ending);
}

}  // namespace

History::History(sqlite3* database, const std::filesystem::path& file, Options options)
    : database_(database),
      folder_(file.parent_path().empty() ? "." : file.parent_path()),
      now_ns_(std::move(options.now_ns)),
      reserve_(folder_ / "history.reserve", options.reserve_bytes) {}

Result<std::unique_ptr<History>> History::open(const std::filesystem::path& file,
                                               Options options) try {
  std::error_code failed;
  const bool is_new = !std::filesystem::exists(file, failed);
  make_private_database(file);
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<History> history(new History(database, file, std::move(options)));
  if (opened != SQLITE_OK) sql::fail(database);
  sqlite3_busy_timeout(database, 2000);
  history->begin();
  if (is_new) {
    sync_folder(history->folder_);
    sync_folder(history->folder_.parent_path());
  }
  return history;
} catch (const std::exception& error) {
  return Error{std::string(error.what()) + " (" + file.string() +
               "); name a folder that can be written with --data DIR"};
}

/// Throws if the disk cannot be read or written. A disk that is full leaves the history readable.
void History::begin() {
  (void)reserve_.take();
  const auto prepare = [this] {
    sql::execute(database_, "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
  };
  try {
    prepare();
  } catch (const sql::Failure& failure) {
    if (!failure.is_of_disk() || !reserve_.release()) throw;
    prepare();
  }
  const auto done = change([this] {
    rows::create_tables(database_);
    chain::create_table(database_);
    sql::execute(database_, kTrialSchema);
    adopt_old_rows(database_, now_ns_());
    for (const auto& id : rows::in_state(database_, PushState::kRunning)) {
      rows::set_state(database_, id, PushState::kInterrupted);
      tell_progress(id);
    }
  });
  if (!done) throw std::runtime_error(done.error().message);
}

History::~History() {
  sqlite3_close(database_);
}

template <class Job>
auto History::change_once(Job job) -> decltype(job()) {
  sql::Transaction transaction(database_);
  if constexpr (std::is_void_v<decltype(job())>) {
    job();
    transaction.commit();
  } else {
    auto result = job();
    transaction.commit();
    return result;
  }
}

template <class Job>
auto History::change(Job job) -> Result<decltype(job())> {
  auto done = sql::attempt([&]() -> decltype(job()) {
    try {
      return change_once(job);
    } catch (const sql::Failure& failure) {
      if (!failure.is_of_disk() || !reserve_.release()) throw;
    }
    return change_once(job);
  });
  write_problem_ = done ? std::string() : done.error().message;
  return done;
}

void History::put_reply(const std::string& push_id, const RobotReply& reply) {
  rows::put_reply(database_, push_id, reply);
  for (const auto& row : rows::told(database_, chain::kReply, push_id))
    if (row.robot == reply.robot)
      chain::append(database_, now_ns_(), chain::kReply, push_id, row.content);
}

void History::put_progress(const std::string& push_id, const Progress& progress) {
  rows::put_progress(database_, push_id, progress);
  tell_progress(push_id);
}

/// Adds the push's progress, as its table has it, to the chain.
void History::tell_progress(const std::string& push_id) {
  for (const auto& row : rows::told(database_, chain::kProgress, push_id))
    chain::append(database_, now_ns_(), chain::kProgress, push_id, row.content);
}

Result<void> History::add(const msg::ProgramPush& push, const Progress& progress) {
  return change([&] {
    if (!rows::put_push(database_, push)) return;
    rows::put_files(database_, push);
    for (const auto& row : rows::told(database_, chain::kPush, push.id))
      chain::append(database_, now_ns_(), chain::kPush, push.id, row.content);
    put_progress(push.id, progress);
  });
}

Result<void> History::add_sending(const std::string& push_id, const Progress& progress,
                                  const std::vector<std::string>& robots) {
  return change([&] {
    const auto listed = rows::told(database_, chain::kReply, push_id);
    for (const auto& robot : robots) {
      const bool is_listed = std::ranges::find(listed, robot, &rows::Told::robot) != listed.end();
      if (!is_listed) put_reply(push_id, {.robot = robot});
    }
    put_progress(push_id, progress);
  });
}

Result<void> History::add_reply(const std::string& push_id, const RobotReply& reply) {
  return change([&] { put_reply(push_id, reply); });
}

Result<void> History::set_progress(const std::string& push_id, const Progress& progress) {
  return change([&] { put_progress(push_id, progress); });
}

Result<std::optional<PushRecord>> History::add_late_reply(const msg::ProgramReply& reply) {
  using Marked = std::optional<PushRecord>;
  auto known = push(reply.id);
  if (!known || !known.value()) return known;
  const auto late = with_late_reply(*known.value(), reply);
  if (!late && !may_be_told_later(*known.value())) return Marked();
  return change([&]() -> Marked {
    if (late) put_reply(reply.id, *late);
    auto now_known = push(reply.id).value();
    const auto progress = now_known ? told_later(*now_known, now_ns_()) : std::nullopt;
    if (!progress) return std::nullopt;
    put_progress(reply.id, *progress);
    now_known->progress = *progress;
    return now_known;
  });
}

Result<void> History::add_order(const OrderRecord& order) {
  return change([&] { rows::put_order(database_, order, now_ns_()); });
}

Result<void> History::add_outcome(const std::string& order_id, OrderOutcome outcome) {
  outcome.told_ns = now_ns_();
  return change([&] { rows::put_outcome(database_, order_id, outcome); });
}

Result<std::vector<OrderRecord>> History::orders(int most) const {
  return sql::attempt([&] { return rows::newest_orders(database_, most); });
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

History::Disk History::check_disk() {
  std::error_code failed;
  const auto room = std::filesystem::space(folder_, failed);
  Disk disk;
  if (!failed) disk.available_bytes = room.available;
  if (!write_problem_.empty())
    (void)change([this] {
      sql::Statement(database_, "INSERT OR REPLACE INTO disk_trial VALUES(1, ?)")
          .bind(now_ns_())
          .run();
    });
  const auto needed = reserve_.bytes();
  if (!reserve_.is_taken() && disk.available_bytes > 3 * needed) (void)reserve_.take();
  disk.has_reserve = reserve_.is_taken();
  const std::string where = folder_.string();
  if (!write_problem_.empty())
    disk.problem = "nothing can be kept, so that pushes are refused: " + write_problem_;
  else if (failed)
    disk.problem = "the disk of " + where + " cannot be asked: " + failed.message();
  else if (needed > 0 && disk.available_bytes < needed)
    disk.problem = "the disk of " + where + " is full: " + megabytes(disk.available_bytes) +
                   " are left" +
                   (disk.has_reserve ? " and a reserve of " + megabytes(needed)
                                     : ", and the reserve is used up");
  else if (needed > 0 && !disk.has_reserve)
    disk.problem = "the disk of " + where +
                   " is nearly full: there is no room for the reserve of " + megabytes(needed);
  return disk;
}

}  // namespace galilean::monitor
