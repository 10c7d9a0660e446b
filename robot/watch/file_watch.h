// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace galilean::robot {

/// Tells when one of several files was saved, in whichever way editors do that: written in place,
/// written aside and renamed, linked, or taken away first. For that it watches their folders, by
/// inotify; a folder that is gone is looked for until it is back. Belongs to one thread.
class FileWatch {
 public:
  /// Throws std::system_error if the system grants no watch.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// From now on this one too, and what it is a link to. It need not be there.
  void add(const std::filesystem::path& file);

  /// Readable when there is something to take.
  [[nodiscard]] int descriptor() const noexcept { return inotify_; }
  /// A folder is gone: take now and then, for nothing tells when it is back.
  [[nodiscard]] bool folder_missing() const noexcept;
  /// One sentence on a folder that cannot be watched and what to do; empty if there is none.
  [[nodiscard]] std::string problem() const;
  /// Whether one of the files was saved since the last call. Does not wait.
  [[nodiscard]] bool take();

 private:
  struct Folder {
    std::filesystem::path path;
    std::set<std::string, std::less<>> files;
    int watch = -1;   ///< -1: it cannot be watched
    int why_not = 0;  ///< errno, where it cannot
  };

  void add_one(const std::filesystem::path& file);
  bool watch(Folder& folder) const;
  [[nodiscard]] bool find_again();
  [[nodiscard]] bool read_events();
  [[nodiscard]] bool is_save(int watch, unsigned mask, const char* name);

  int inotify_;
  std::vector<Folder> folders_;
};

}  // namespace galilean::robot
