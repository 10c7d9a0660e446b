// SPDX-License-Identifier: BSD-3-Clause
#include "robot/watch/file_watch.h"

#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "robot/watch/links.h"

namespace galilean::robot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kGone = IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED;
constexpr std::uint32_t kLookedFor =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

/// Returns whether the file was made as a link. A link is complete at once. Any other new file is
/// still empty, and is closed later.
bool is_link(const fs::path& file) {
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0) return false;
  return S_ISLNK(status.st_mode) || status.st_nlink > 1;
}

bool is_there(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(file, unknown);
}

std::string advice(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "make that folder again";
    case EACCES:
      return "give this user the right to read that folder";
    case ENOSPC:
      return "raise fs.inotify.max_user_watches";
    default:
      return "check that folder";
  }
}

}  // namespace

FileWatch::FileWatch() : inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (inotify_ < 0)
    throw std::system_error(errno, std::generic_category(),
                            "files cannot be watched (see fs.inotify.max_user_instances)");
}

FileWatch::~FileWatch() {
  close(inotify_);
}

bool FileWatch::add(const std::vector<fs::path>& files) {
  files_.insert(files.begin(), files.end());
  std::vector<Folder> before = std::exchange(folders_, wanted_folders());
  for (Folder& folder : folders_) watch(folder);
  for (const Folder& folder : before) release(folder.watch);
  return std::ranges::any_of(folders_, [&](const Folder& folder) {
    return folder.watch >= 0 &&
           std::ranges::find(before, folder.watch, &Folder::watch) == before.end();
  });
}

std::vector<FileWatch::Folder> FileWatch::wanted_folders() const {
  std::vector<Folder> folders;
  const auto want = [&](const fs::path& place, bool is_file) {
    const fs::path path = place.parent_path();
    auto folder = std::ranges::find(folders, path, &Folder::path);
    if (folder == folders.end()) folder = folders.insert(folder, Folder{.path = path, .names = {}});
    folder->names.insert(place.filename().string());
    folder->holds_file |= is_file;
  };
  for (const fs::path& file : files_) {
    const FollowedPath followed = follow_links(file);
    for (const fs::path& link : followed.links) want(link, false);
    want(followed.file, true);
  }
  return folders;
}

/// Ends a watch, unless a folder has the same.
void FileWatch::release(int watch) const {
  if (watch >= 0 && std::ranges::find(folders_, watch, &Folder::watch) == folders_.end())
    inotify_rm_watch(inotify_, watch);
}

bool FileWatch::watch(Folder& folder) const {
  folder.watch = inotify_add_watch(inotify_, folder.path.c_str(), kLookedFor);
  folder.watch_error = folder.watch < 0 ? errno : 0;
  return folder.watch >= 0;
}

bool FileWatch::folder_missing() const noexcept {
  return std::ranges::any_of(
      folders_, [](const Folder& folder) { return folder.holds_file && folder.watch < 0; });
}

std::string FileWatch::problem() const {
  for (const Folder& folder : folders_)
    if (folder.holds_file && folder.watch < 0)
      return "Saves in " + folder.path.string() + " are not noticed (" +
             std::strerror(folder.watch_error) + "): " + advice(folder.watch_error) + '.';
  return "";
}

bool FileWatch::take() {
  const bool saved = read_events();
  return find_again() || saved;
}

/// Watches folders again that are back. Returns whether one holds a file, which may have changed
/// meanwhile.
bool FileWatch::find_again() {
  bool found = false;
  for (Folder& folder : folders_)
    if (folder.watch < 0 && watch(folder))
      found |= std::ranges::any_of(
          folder.names, [&](const std::string& name) { return is_there(folder.path / name); });
  return found;
}

bool FileWatch::read_events() {
  alignas(inotify_event) std::array<char, 16384> buffer;
  bool saved = false;
  for (ssize_t size; (size = read(inotify_, buffer.data(), buffer.size())) > 0;)
    for (const char* at = buffer.data(); at < buffer.data() + size;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(at);
      saved |= is_save(event.wd, event.mask, event.len > 0 ? event.name : "");
      at += sizeof(inotify_event) + event.len;
    }
  return saved;
}

bool FileWatch::is_save(int watch, unsigned mask, const char* name) {
  if (mask & IN_Q_OVERFLOW) return true;
  const auto folder = std::ranges::find(folders_, watch, &Folder::watch);
  if (folder == folders_.end()) return false;
  if (mask & kGone) {
    // A folder that was moved away would still be watched at its new place.
    inotify_rm_watch(inotify_, watch);
    folder->watch = -1;
    folder->watch_error = ENOENT;
    return false;
  }
  if (!folder->names.contains(name)) return false;
  return (mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) || is_link(folder->path / name);
}

}  // namespace galilean::robot
