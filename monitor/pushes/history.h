// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/result.h"
#include "monitor/pushes/push.h"
#include "monitor/pushes/swap_transaction.h"

struct sqlite3;

namespace galilean::monitor {

/// A push as it is remembered.
struct PushRecord {
  std::string id;
  std::int64_t pushed_ns = 0;  ///< since the Unix epoch
  std::string author;
  std::string program;  ///< the main file's name
  std::string hash;
  std::vector<std::string> targets;  ///< empty: the team
  SwapProgress progress;
  std::vector<PushAnswer> answers;
};

/// Every push for ever: text, hash, who, when, to whom, how far it came and the outcome robot by
/// robot. What a call
/// has returned from survives kill -9 and power loss (SQLite, write-ahead log, synchronous FULL).
/// A program's text is kept once, under its hash. Not for several threads at once.
class History {
 public:
  /// Makes the folder and the file where they are missing. A push that was under way when its
  /// monitor ended is from now on remembered as interrupted.
  [[nodiscard]] static Result<std::unique_ptr<History>> open(const std::filesystem::path& file);
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Throws std::runtime_error where the disk refuses, as all below.
  void add(const msg::ProgramPush& push, const SwapProgress& progress = {});
  void set_progress(const std::string& push_id, const SwapProgress& progress);
  void add_answer(const std::string& push_id, const PushAnswer& answer);

  /// The newest first.
  [[nodiscard]] std::vector<PushRecord> pushes(int most) const;
  [[nodiscard]] std::optional<PushRecord> push(const std::string& id) const;
  /// The last time that somebody pushed this program.
  [[nodiscard]] std::optional<PushRecord> last_push_of(const std::string& hash) const;
  /// The files of the program that was pushed under this hash, the main file first; the beginning
  /// of a hash does where no other begins so. Nothing if there is none, or more than one.
  [[nodiscard]] std::optional<std::vector<bhdl::SourceFile>> program(const std::string& hash) const;

 private:
  explicit History(sqlite3* database) : database_(database) {}

  sqlite3* database_;
};

}  // namespace galilean::monitor
