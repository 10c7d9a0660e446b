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

/// Makes a change of names in a folder last, also if the power fails. A folder that cannot be
/// synced has the new name at once all the same.
void sync_folder(const fs::path& folder) noexcept {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
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

Result<void> replace_private_file(const fs::path& file, std::string_view text) {
  std::string draft = file.string() + ".XXXXXX";
  const int descriptor = mkostemp(draft.data(), O_CLOEXEC);  // mode 0600
  if (descriptor < 0) return cannot(file, "written");
  const bool written = write_all(descriptor, text) && fsync(descriptor) == 0;
  int problem = errno;
  close(descriptor);
  if (written && rename(draft.c_str(), file.c_str()) == 0) {
    sync_folder(file.has_parent_path() ? file.parent_path() : fs::path("."));
    return {};
  }
  if (written) problem = errno;
  unlink(draft.c_str());
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
