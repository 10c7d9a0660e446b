// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "monitor/pushes/history/push_record.h"

struct sqlite3;

namespace galilean::monitor {

/// Keeps every push for ever: its program, author, time, targets, progress and replies. A change
/// survives kill -9 and power loss once the call has returned (SQLite, write-ahead log, synchronous
/// FULL). What is newer goes by the order in which the history was told, never by a clock. A
/// program's text is stored once, under its hash. Only one thread may use the history at a time.
/// Errors of all calls: the disk cannot be read or written.
class History {
 public:
  /// Opens the history. Makes the folder and the file if they are missing. A push that was still
  /// running when its monitor ended is marked as interrupted.
  [[nodiscard]] static Result<std::unique_ptr<History>> open(const std::filesystem::path& file);
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Keeps the program under the hash of its files, whatever hash `announced` names: anybody on DDS
  /// could announce that of another program.
  [[nodiscard]] Result<void> add(const msg::ProgramPush& announced, const Progress& progress = {});
  [[nodiscard]] Result<void> set_progress(const std::string& push_id, const Progress& progress);
  [[nodiscard]] Result<void> add_reply(const std::string& push_id, const RobotReply& reply);

  /// Returns the newest pushes, at most `most` of them, the newest first.
  [[nodiscard]] Result<std::vector<PushRecord>> pushes(int most) const;
  /// Returns nothing if there was no such push.
  [[nodiscard]] Result<std::optional<PushRecord>> push(const std::string& id) const;
  /// Returns the last push of this program; nothing if it was never pushed.
  [[nodiscard]] Result<std::optional<PushRecord>> last_push_of(const std::string& hash) const;
  /// Returns the files of the program with this hash, the main file first. The beginning of the
  /// hash is enough if no other hash begins with it. Returns nothing if no program fits, or more
  /// than one. Errors: its text was recorded under a wrong hash, by an earlier release.
  [[nodiscard]] Result<std::optional<std::vector<bhdl::SourceFile>>> program(
      const std::string& hash) const;

 private:
  explicit History(sqlite3* database) : database_(database) {}

  sqlite3* database_;
};

}  // namespace galilean::monitor
