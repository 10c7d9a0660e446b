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
#include "monitor/pushes/history/disk_reserve.h"
#include "monitor/pushes/history/order_record.h"
#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/history/verification.h"

struct sqlite3;

namespace galilean::monitor {

/// Keeps every push for ever: its program, author, time, targets, progress and replies; and every
/// other order with its outcomes. A change survives kill -9 and power loss once the call has
/// returned (SQLite, write-ahead log, synchronous FULL). All of it is in one chain of rows, each
/// with the hash of the row before it. What is newer goes by the order in which the history was
/// told, never by a clock. A program's text is stored once, under the hash that it has. Only one
/// thread may use the history at a time. Errors of all calls: the disk cannot be read or written,
/// also after the reserve was given up.
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
  };

  /// Opens the history. Makes the folder and the file if they are missing. A push that was still
  /// running when its monitor ended is marked as interrupted. A history without a chain is taken
  /// over.
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
  [[nodiscard]] Result<void> set_progress(const std::string& push_id, const Progress& progress);
  [[nodiscard]] Result<void> add_reply(const std::string& push_id, const RobotReply& reply);
  /// Takes in a reply to a push that is over: keeps it if it tells more than is known, and marks
  /// the push as told later if all its robots run it now. Returns the push if it was marked.
  [[nodiscard]] Result<std::optional<PushRecord>> add_late_reply(const msg::ProgramReply& reply);

  /// Adds an order that is no push. Does nothing if there is one of this id.
  [[nodiscard]] Result<void> add_order(const OrderRecord& order);
  /// Adds what became of an order; `told_ns` is set here.
  [[nodiscard]] Result<void> add_outcome(const std::string& order_id, OrderOutcome outcome);
  /// Returns the newest orders, at most `most` of them, the newest first.
  [[nodiscard]] Result<std::vector<OrderRecord>> orders(int most) const;

  /// Returns the newest pushes, at most `most` of them, the newest first.
  [[nodiscard]] Result<std::vector<PushRecord>> pushes(int most) const;
  /// Returns nothing if there was no such push.
  [[nodiscard]] Result<std::optional<PushRecord>> push(const std::string& id) const;
  /// Returns the last push of this program; nothing if it was never pushed.
  [[nodiscard]] Result<std::optional<PushRecord>> last_push_of(const std::string& hash) const;
  /// Returns the files of the program with this hash, the main file first. The beginning of the
  /// hash is enough if no other hash begins with it. Returns nothing if no program fits, or more
  /// than one. Errors: also if the text does not have the hash.
  [[nodiscard]] Result<std::optional<std::vector<bhdl::SourceFile>>> program(
      const std::string& hash) const;

  [[nodiscard]] Result<Verification> verify() const { return monitor::verify(database_); }
  /// Looks at the disk: takes the reserve again once there is room, and tries to write if the last
  /// write failed. Call it some times a second.
  [[nodiscard]] Disk check_disk();

 private:
  History(sqlite3* database, const std::filesystem::path& file, Options options);
  void begin();
  /// Runs `job` in a transaction. If the disk is full, gives the reserve up and tries once more.
  template <class Job>
  auto change(Job job) -> Result<decltype(job())>;
  template <class Job>
  auto change_once(Job job) -> decltype(job());
  void put_reply(const std::string& push_id, const RobotReply& reply);
  void put_progress(const std::string& push_id, const Progress& progress);
  void tell_progress(const std::string& push_id);

  sqlite3* database_;
  std::filesystem::path folder_;
  std::function<std::int64_t()> now_ns_;
  DiskReserve reserve_;
  std::string write_problem_;  ///< why the last write failed; empty: it did not
};

}  // namespace galilean::monitor
