// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace galilean::monitor {

/// The disk under every SQLite database that is opened while this lives. Each write asks first what
/// shall become of it. Nothing waits for a real disk. At most one may live at a time.
class FaultyDisk {
 public:
  enum class Fate {
    kWritten,
    kFull,       ///< SQLite is told that the disk is full
    kDieBefore,  ///< the process is killed before anything is written
    kDieHalfway  ///< the process is killed when half of the bytes are written
  };
  /// `write` counts the writes of this process: 1, 2, 3 …
  using Decide = std::function<Fate(std::int64_t write)>;

  explicit FaultyDisk(Decide decide);
  ~FaultyDisk();
  FaultyDisk(const FaultyDisk&) = delete;
  FaultyDisk& operator=(const FaultyDisk&) = delete;

  /// From now on another one decides, and writes are counted from 1.
  void decide_by(Decide decide) {
    decide_ = std::move(decide);
    writes_ = 0;
  }
  [[nodiscard]] std::int64_t writes() const noexcept { return writes_; }

 private:
  /// SQLite's methods of a kind of file, with ours in the place of some. They come first, so that a
  /// file's pointer to its methods leads to the real ones, too.
  struct Methods {
    sqlite3_io_methods ours;
    const sqlite3_io_methods* real;
  };

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out);
  static int write(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 at);
  static int sync(sqlite3_file* file, int flags);
  [[nodiscard]] const sqlite3_io_methods* methods_for(const sqlite3_io_methods* real);

  static FaultyDisk* now_;
  sqlite3_vfs* real_;
  sqlite3_vfs ours_;
  Decide decide_;
  std::int64_t writes_ = 0;
  std::map<const sqlite3_io_methods*, std::unique_ptr<Methods>> methods_;
};

}  // namespace galilean::monitor
