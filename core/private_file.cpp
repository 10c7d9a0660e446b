// SPDX-License-Identifier: BSD-3-Clause
#include "core/private_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace galilean {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kOwnersFile = 0600;
constexpr mode_t kOwnersFolder = 0700;
constexpr mode_t kOthersRights = 0077;

Error cannot(const fs::path& path, const char* what) {
  return Error{path.string() + " cannot be " + what + ": " + std::strerror(errno)};
}

bool is_open_to_others(const struct stat& status) noexcept {
  return S_ISREG(status.st_mode) && (status.st_mode & kOthersRights) != 0;
}

/// Writes a new file beside `file`, which the disk then has. Returns its name. Errors: it cannot be
/// written, and nothing of it is left. The sentence names `file`.
Result<std::string> write_draft(const fs::path& file, std::string_view text, mode_t mode) {
  std::string draft = file.string() + ".XXXXXX";
  const int descriptor = mkostemp(draft.data(), O_CLOEXEC);  // mode 0600
  if (descriptor < 0) return cannot(file, "written");
  const bool is_written = write_all(descriptor, text) &&
                          (mode == kOwnersFile || fchmod(descriptor, mode) == 0) &&
                          fsync(descriptor) == 0;
  const int problem = errno;
  close(descriptor);
  if (is_written) return draft;
  unlink(draft.c_str());
  errno = problem;
  return cannot(file, "written");
}

}  // namespace

Result<int> open_private_file(const fs::path& file, int flags) {
  const int descriptor = open(file.c_str(), flags | O_CREAT | O_CLOEXEC, kOwnersFile);
  if (descriptor < 0) return cannot(file, "written");
  struct stat status {};
  if (fstat(descriptor, &status) == 0 && is_open_to_others(status))
    fchmod(descriptor, status.st_mode & kOwnersFolder);
  return descriptor;
}

void take_from_others(const fs::path& file) noexcept {
  struct stat status {};
  if (stat(file.c_str(), &status) == 0 && is_open_to_others(status))
    chmod(file.c_str(), status.st_mode & kOwnersFolder);
}

bool write_all(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const auto count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void sync_folder(const fs::path& folder) noexcept {
  const char* name = folder.empty() ? "." : folder.c_str();
  const int descriptor = open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

Result<void> replace_private_file(const fs::path& file, std::string_view text) {
  const auto draft = write_draft(file, text, kOwnersFile);
  if (!draft) return draft.error();
  if (rename(draft.value().c_str(), file.c_str()) == 0) {
    sync_folder(file.parent_path());
    return {};
  }
  const int problem = errno;
  unlink(draft.value().c_str());
  errno = problem;
  return cannot(file, "written");
}

Result<void> write_new_file(const fs::path& file, std::string_view text, mode_t mode) {
  const auto draft = write_draft(file, text, mode);
  if (!draft) return draft.error();
  // The link fails if the file is there. What it holds is valid then.
  const bool is_placed = link(draft.value().c_str(), file.c_str()) == 0 || errno == EEXIST;
  const int problem = errno;
  unlink(draft.value().c_str());
  if (is_placed) {
    sync_folder(file.parent_path());
    return {};
  }
  errno = problem;
  return cannot(file, "written");
}

Result<void> make_private_folder(const fs::path& folder) {
  std::error_code unknown;
  if (folder.empty() || fs::is_directory(folder, unknown)) return {};
  if (const auto parent = folder.parent_path(); parent != folder)
    if (auto made = make_private_folder(parent); !made) return made;
  if (mkdir(folder.c_str(), kOwnersFolder) == 0) return {};
  const int problem = errno;
  // Another process may have been quicker.
  if (problem == EEXIST && fs::is_directory(folder, unknown)) return {};
  errno = problem;
  return cannot(folder, "made");
}

}  // namespace galilean
