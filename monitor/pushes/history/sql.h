// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/result.h"

namespace galilean::monitor::sql {

/// What SQLite refused.
struct Failure : std::runtime_error {
  Failure(const std::string& what, int result) : std::runtime_error(what), code(result) {}
  int code;  ///< SQLite's primary result code
  /// Returns whether the disk is full, or fails.
  [[nodiscard]] bool is_of_disk() const noexcept {
    return code == SQLITE_FULL || code == SQLITE_IOERR;
  }
  /// Returns whether the same may be done later, once the disk or another process lets it be done.
  [[nodiscard]] bool may_pass() const noexcept {
    return is_of_disk() || code == SQLITE_BUSY || code == SQLITE_LOCKED ||
           code == SQLITE_READONLY || code == SQLITE_CANTOPEN || code == SQLITE_NOMEM;
  }
};

[[noreturn]] inline void fail(sqlite3* database) {
  constexpr int kPrimary = 0xff;
  throw Failure(std::string("the history of pushes: ") + sqlite3_errmsg(database),
                sqlite3_errcode(database) & kPrimary);
}

/// Runs `job`. Returns what it returns, or what it threw.
template <class Job>
auto attempt(Job job) -> Result<decltype(job())> try {
  if constexpr (std::is_void_v<decltype(job())>) {
    job();
    return {};
  } else {
    return job();
  }
} catch (const std::exception& error) {
  return Error{error.what()};
}

inline void execute(sqlite3* database, const char* text) {
  if (sqlite3_exec(database, text, nullptr, nullptr, nullptr) != SQLITE_OK) fail(database);
}

/// A prepared statement. Parameters count from 1, columns from 0.
class Statement {
 public:
  Statement(sqlite3* database, const std::string& text) : database_(database) {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database, text.c_str(), -1, &made, nullptr) != SQLITE_OK) fail(database);
    statement_.reset(made);
  }

  Statement& bind(std::string_view value) {
    sqlite3_bind_text(statement_.get(), ++bound_, value.data(), static_cast<int>(value.size()),
                      SQLITE_TRANSIENT);
    return *this;
  }
  Statement& bind(std::int64_t value) {
    sqlite3_bind_int64(statement_.get(), ++bound_, value);
    return *this;
  }
  Statement& bind(double value) {
    sqlite3_bind_double(statement_.get(), ++bound_, value);
    return *this;
  }
  /// Steps to the next row. Returns false if there are no more.
  bool step() {
    const int result = sqlite3_step(statement_.get());
    if (result != SQLITE_ROW && result != SQLITE_DONE) fail(database_);
    return result == SQLITE_ROW;
  }
  void run() {
    while (step()) {
    }
  }
  [[nodiscard]] std::string text(int column) const {
    const auto* bytes = sqlite3_column_text(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size))
                 : std::string();
  }
  [[nodiscard]] std::int64_t integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
  }
  [[nodiscard]] double number(int column) const {
    return sqlite3_column_double(statement_.get(), column);
  }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
};

/// A transaction. Statements that are executed while it lives take effect with `commit`; without
/// it, they are undone.
class Transaction {
 public:
  explicit Transaction(sqlite3* database) : database_(database) {
    execute(database_, "BEGIN IMMEDIATE");
  }
  ~Transaction() {
    if (open_) sqlite3_exec(database_, "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit() {
    execute(database_, "COMMIT");
    open_ = false;
  }

 private:
  sqlite3* database_;
  bool open_ = true;
};

/// A transaction that reads. What others write while it lives is not seen.
class Snapshot {
 public:
  explicit Snapshot(sqlite3* database) : database_(database) { execute(database_, "BEGIN"); }
  ~Snapshot() { sqlite3_exec(database_, "ROLLBACK", nullptr, nullptr, nullptr); }
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  sqlite3* database_;
};

}  // namespace galilean::monitor::sql
