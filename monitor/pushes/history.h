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
#include "monitor/pushes/push_record.h"

struct sqlite3;

namespace galilean::monitor {

/// Every push for ever: text, hash, who, when, to whom, how far it came and what each robot
/// replied. What a call has returned from survives kill -9 and power loss (SQLite, write-ahead log,
/// synchronous FULL). A program's text is kept once, under its hash. Not for several threads at
/// once. Errors of all calls: the disk refuses.
class History {
 public:
  /// Makes the folder and the file where they are missing. A push that was under way when its
  /// monitor ended is from now on remembered as interrupted.
  [[nodiscard]] static Result<std::unique_ptr<History>> open(const std::filesystem::path& file);
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  [[nodiscard]] Result<void> add(const msg::ProgramPush& push, const Progress& progress = {});
  [[nodiscard]] Result<void> set_progress(const std::string& push_id, const Progress& progress);
  [[nodiscard]] Result<void> add_reply(const std::string& push_id, const RobotReply& reply);

  /// Returns the newest `most`, the newest first.
  [[nodiscard]] Result<std::vector<PushRecord>> pushes(int most) const;
  /// Returns nothing if there was no such push.
  [[nodiscard]] Result<std::optional<PushRecord>> push(const std::string& id) const;
  /// Returns the last time that somebody pushed this program; nothing if nobody did.
  [[nodiscard]] Result<std::optional<PushRecord>> last_push_of(const std::string& hash) const;
  /// Returns the files of the program that was pushed under this hash, the main file first; the
  /// beginning of a hash does where no other begins so. Nothing if there is none, or more than one.
  [[nodiscard]] Result<std::optional<std::vector<bhdl::SourceFile>>> program(
      const std::string& hash) const;

 private:
  explicit History(sqlite3* database) : database_(database) {}

  sqlite3* database_;
};

}  // namespace galilean::monitor
