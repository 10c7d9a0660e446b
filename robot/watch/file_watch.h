// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace galilean::robot {

/// Notices when one of several files was saved, in whichever way editors save: written in place,
/// written elsewhere and renamed, linked, or removed first. A file was also saved if a link on its
/// path leads elsewhere now, such as a link to a folder. It watches the folders of the files and of
/// those links by inotify. A folder that is gone is tried again in `take` until it is back. It
/// belongs to one thread.
class FileWatch {
 public:
  /// Errors: throws std::system_error if the system grants no watch.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Adds files, which need not exist, to those that are watched. Follows the links on all paths
  /// anew. Returns whether a folder is watched only from now on: what was saved there earlier is
  /// not noticed, so that its files must be read again. Requires: it is called after each save,
  /// because the save may have changed a link.
  [[nodiscard]] bool add(const std::vector<std::filesystem::path>& files);

  /// Returns a file descriptor for poll, which is readable when there is something to take.
  [[nodiscard]] int descriptor() const noexcept { return inotify_; }
  /// Returns whether a folder cannot be watched. The caller must then call `take` now and then,
  /// because nothing signals when the folder is back.
  [[nodiscard]] bool folder_missing() const noexcept;
  /// Returns one sentence on a folder that cannot be watched and what to do, or an empty text.
  [[nodiscard]] std::string problem() const;
  /// Returns whether one of the files was saved since the last call. It does not wait.
  [[nodiscard]] bool take();

 private:
  struct Folder {
    std::filesystem::path path;
    std::set<std::string, std::less<>> names;  ///< of files and links in it
    bool holds_file = false;                   ///< holds more than links
    int watch = -1;       ///< inotify's number; -1: the folder cannot be watched
    int watch_error = 0;  ///< errno if the folder cannot be watched, else 0
  };

  [[nodiscard]] std::vector<Folder> wanted_folders() const;
  bool watch(Folder& folder) const;
  void release(int watch) const;
  [[nodiscard]] bool find_again();
  [[nodiscard]] bool read_events();
  [[nodiscard]] bool is_save(int watch, unsigned mask, const char* name);

  int inotify_;
  std::set<std::filesystem::path> files_;
  std::vector<Folder> folders_;
};

}  // namespace galilean::robot
