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

/// Makes the database's file, because SQLite would let others read what it makes. Where this fails,
/// SQLite says why. The files that SQLite puts beside it get its mode, but an earlier release may
/// have left some.
void make_private_database(const std::filesystem::path& file) {
  (void)make_private_folder(file.parent_path());
  if (const auto made = open_private_file(file, O_WRONLY | O_EXCL)) close(made.value());
  for (const char* ending : {"", "-wal", "-shm"}) take_from_others(file.string() + ending);
}

}  // namespace

History::History(sqlite3* database, const std::filesystem::path& file, Options options,
                 HistoryLock lock)
    : lock_(std::move(lock)),
      database_(database),
      folder_(file.parent_path().empty() ? "." : file.parent_path()),
      now_ns_(std::move(options.now_ns)),
      reserve_(folder_ / "history.reserve", options.reserve_bytes),
      probe_(folder_ / "history.probe") {}

Result<std::unique_ptr<History>> History::open(const std::filesystem::path& file,
                                               Options options) try {
  std::error_code failed;
  const bool is_new = !std::filesystem::exists(file, failed);
  make_private_database(file);
  // A second monitor would take the pushes that are under way for interrupted ones.
  auto lock = HistoryLock::take(lock_file_of(file));
  if (!lock)
    return Error{"another monitor keeps its history in " + file.string() +
                 "; end that one, or name another folder with --data DIR"};
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<History> history(
      new History(database, file, std::move(options), std::move(lock).value()));
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
  (void)pay();
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
  may_pass_ = false;
  const int before = sqlite3_total_changes(database_);
  const auto once = [&]() -> decltype(job()) {
    try {
      return change_once(job);
    } catch (const sql::Failure& failure) {
      may_pass_ = failure.may_pass();
      throw;
    }
  };
  auto done = sql::attempt([&]() -> decltype(job()) {
    try {
      return once();
    } catch (const sql::Failure& failure) {
      if (!failure.is_of_disk() || !reserve_.release()) throw;
    }
    return once();
  });
  // What changes nothing does not tell whether the disk can be written again.
  if (!done)
    write_problem_ = done.error().message;
  else if (sqlite3_total_changes(database_) != before)
    write_problem_.clear();
  return done;
}

Result<void> History::keep(const std::string& key, OwedChanges::Change wanted) {
  owed_.add(key, std::move(wanted));
  return pay();
}

Result<void> History::pay() {
  Result<void> done;
  while (!owed_.empty()) {
    done = change([this] { owed_.oldest()(); });
    if (!done && may_pass_) break;
    owed_.drop_oldest();
  }
  return done;
}

void History::try_disk() {
  (void)change([this] {
    sql::Statement(database_, "INSERT OR REPLACE INTO disk_trial VALUES(1, ?)")
        .bind(now_ns_())
        .run();
  });
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

// What waits for the disk comes first, so that the chain's order is that of what happened. A push
// is not begun before it.
Result<void> History::add(const msg::ProgramPush& push, const Progress& progress) {
  if (auto paid = pay(); !owed_.empty()) return paid;
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
  if (auto paid = pay(); !owed_.empty()) return paid;
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
  return keep("reply " + push_id + ' ' + reply.robot,
              [this, push_id, reply] { put_reply(push_id, reply); });
}

Result<void> History::set_progress(const std::string& push_id, const Progress& progress) {
  // A push that could not be written was refused, and has no progress.
  const auto listed = sql::attempt([&] { return rows::told(database_, chain::kPush, push_id); });
  if (listed && listed.value().empty()) return {};
  return keep("progress " + push_id,
              [this, push_id, progress] { put_progress(push_id, progress); });
}

Result<std::optional<PushRecord>> History::add_late_reply(const msg::ProgramReply& reply) {
  using Marked = std::optional<PushRecord>;
  auto known = push(reply.id);
  if (!known || !known.value()) return known;
  const auto late = with_late_reply(*known.value(), reply);
  if (!late && !may_be_told_later(*known.value())) return Marked();
  if (auto paid = pay(); !owed_.empty()) return paid.error();
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
  return keep("order " + order.id, [this, order] { rows::put_order(database_, order, now_ns_()); });
}

Result<void> History::add_outcome(const std::string& order_id, OrderOutcome outcome) {
  outcome.told_ns = now_ns_();
  return keep("outcome " + order_id + ' ' + outcome.of,
              [this, order_id, outcome] { rows::put_outcome(database_, order_id, outcome); });
}

Result<void> History::add_refused_push(const RefusedPush& refused) {
  return keep("refused " + refused.id,
              [this, refused] { rows::put_refused_push(database_, refused, now_ns_()); });
}

Result<std::optional<RefusedPush>> History::refused_push(const std::string& id) const {
  return sql::attempt([&] { return rows::refused_push(database_, id); });
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
        rows::select_pushes(database_, std::string("WHERE push.hash = ? AND ") + rows::kBroughtIt +
                                           " ORDER BY sequence DESC LIMIT 1");
    found.bind(hash);
    return rows::record_of(database_, found);
  });
}

Result<std::optional<std::vector<bhdl::SourceFile>>> History::program(
    const std::string& hash) const {
  return sql::attempt([&] { return rows::files_of(database_, hash); });
}

}  // namespace galilean::monitor
