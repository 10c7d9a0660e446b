// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/pushes/history/disk_probe.h"
#include "monitor/pushes/history/disk_reserve.h"
#include "monitor/pushes/history/history_lock.h"
#include "monitor/pushes/history/order_record.h"
#include "monitor/pushes/history/owed_changes.h"
#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/history/verification.h"

struct sqlite3;

namespace galilean::monitor {

/// Keeps every push for ever: its program, author, time, targets, progress and replies; and every
/// other order with its outcomes. A change survives kill -9 and power loss once the call has
/// returned (SQLite, write-ahead log, synchronous FULL). All of it is in one chain of rows, each
/// with the hash of the row before it. What is newer goes by the order in which the history was
/// told, never by a clock. A program's text is stored once, under the hash that it has. Only one
/// thread may use the history at a time, and only one process. Errors of all calls: the disk cannot
/// be read or written, also after the reserve was given up.
///
/// What a push or an order has become has happened, whether or not the disk takes it. While the
/// disk does not, such changes wait in memory, and are written in their order once it does: each
/// call that changes something tries, and so does check_disk.
class History {
 public:
  struct Options {
    /// Returns the time since the Unix epoch that rows bear.
    std::function<std::int64_t()> now_ns = wire::wall_clock_ns;
    /// The room on the disk that is given up when the disk is full; 0: none.
    std::uintmax_t reserve_bytes = 8 << 20;
  };
  /// The state of the disk under the history.
  struct Disk {
    std::string problem;  ///< a clause; empty: all is well
    bool has_reserve = false;
    std::uintmax_t available_bytes = 0;
    std::size_t owed = 0;    ///< changes that wait in memory until the disk takes them
    std::uint64_t lost = 0;  ///< those of them that were lost, because too many waited
  };

  /// Opens the history. Makes the folder and the file if they are missing. A push that was still
  /// running when its monitor ended is marked as interrupted. A history without a chain is taken
  /// over. Errors: also if another monitor uses it.
  [[nodiscard]] static Result<std::unique_ptr<History>> open(const std::filesystem::path& file,
                                                             Options options);
  [[nodiscard]] static Result<std::unique_ptr<History>> open(const std::filesystem::path& file) {
    return open(file, Options());
  }
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Adds a push with the hash of its files, whatever hash it announces: anybody on DDS could
  /// announce that of another program. Does nothing if there is a push of this id.
  [[nodiscard]] Result<void> add(const msg::ProgramPush& push, const Progress& progress = {});
  /// Adds the intent to send a push to robots: each of them that is not listed has given no answer.
  [[nodiscard]] Result<void> add_sending(const std::string& push_id, const Progress& progress,
                                         const std::vector<std::string>& robots);
  /// Does nothing if there is no such push. If the disk fails, it waits for the disk; so do a
  /// reply, an order and an outcome.
  [[nodiscard]] Result<void> set_progress(const std::string& push_id, const Progress& progress);
  [[nodiscard]] Result<void> add_reply(const std::string& push_id, const RobotReply& reply);
  /// Takes in a reply to a push that is over: keeps it if it tells more than is known, and marks
  /// the push as told later if all its robots run it now. Returns the push if it was marked.
  [[nodiscard]] Result<std::optional<PushRecord>> add_late_reply(const msg::ProgramReply& reply);

  /// Adds an order that is no push. Does nothing if there is one of this id.
  [[nodiscard]] Result<void> add_order(const OrderRecord& order);
  /// Adds what became of an order; `told_ns` is set here.
  [[nodiscard]] Result<void> add_outcome(const std::string& order_id, OrderOutcome outcome);
  /// Adds a push that was refused, so that the same order is refused again, also by the next
  /// monitor. It is listed among the orders. Does nothing if there is one of this id.
  [[nodiscard]] Result<void> add_refused_push(const RefusedPush& refused);
  /// Returns nothing if no push of this id was refused.
  [[nodiscard]] Result<std::optional<RefusedPush>> refused_push(const std::string& id) const;
  /// Returns the newest orders, at most `most` of them, the newest first.
  [[nodiscard]] Result<std::vector<OrderRecord>> orders(int most) const;

  /// Returns the newest pushes, at most `most` of them, the newest first.
  [[nodiscard]] Result<std::vector<PushRecord>> pushes(int most) const;
  /// Returns nothing if there was no such push.
  [[nodiscard]] Result<std::optional<PushRecord>> push(const std::string& id) const;
  /// Returns the last push of this program; nothing if it was never pushed. What others announce
  /// over DDS counts only if a robot took it.
  [[nodiscard]] Result<std::optional<PushRecord>> last_push_of(const std::string& hash) const;
  /// Returns the files of the program with this hash, the main file first. The beginning of the
  /// hash is enough if no other hash begins with it. Returns nothing if no program fits, or more
  /// than one. Errors: also if the text does not have the hash.
  [[nodiscard]] Result<std::optional<std::vector<bhdl::SourceFile>>> program(
      const std::string& hash) const;

  [[nodiscard]] Result<Verification> verify() const { return monitor::verify(database_); }
  /// Looks at the disk, and writes to it, so that one that fails is noticed before it is needed.
  /// Takes the reserve again once there is room, and writes what waits for the disk. Call it some
  /// times a second.
  [[nodiscard]] Disk check_disk();
  /// Returns why the history does not hold what was told last; empty: it does.
  [[nodiscard]] const std::string& not_kept() const noexcept { return write_problem_; }

 private:
  History(sqlite3* database, const std::filesystem::path& file, Options options, HistoryLock lock);
  void begin();
  /// Runs `job` in a transaction. If the disk is full, gives the reserve up and tries once more.
  template <class Job>
  auto change(Job job) -> Result<decltype(job())>;
  template <class Job>
  auto change_once(Job job) -> decltype(job());
  /// Makes a change now, or once the disk takes it. Errors: it waits, or it cannot be made.
  Result<void> keep(const std::string& key, OwedChanges::Change wanted);
  /// Makes the changes that wait, up to the first one for which the disk still fails.
  Result<void> pay();
  /// Makes a change that says nothing.
  void try_disk();
  [[nodiscard]] std::string problem_of(const Disk& disk, const Result<void>& probed) const;
  void put_reply(const std::string& push_id, const RobotReply& reply);
  void put_progress(const std::string& push_id, const Progress& progress);
  void tell_progress(const std::string& push_id);

  HistoryLock lock_;
  sqlite3* database_;
  std::filesystem::path folder_;
  std::function<std::int64_t()> now_ns_;
  DiskReserve reserve_;
  DiskProbe probe_;
  OwedChanges owed_;
  std::string write_problem_;  ///< why the last write failed; empty: it did not
  bool may_pass_ = false;      ///< it failed for a reason that may pass
};

}  // namespace galilean::monitor
