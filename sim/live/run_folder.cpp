// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

#include "core/private_file.h"

namespace galilean::sim {
namespace {

namespace fs = std::filesystem;

bool is_plain(const std::string& name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return !name.empty() && name.size() <= 64 &&
         name.find_first_not_of(kAllowed) == std::string::npos;
}

fs::path runtime_folder() {
  const char* given = std::getenv("XDG_RUNTIME_DIR");
  std::error_code error;
  if (given && fs::is_directory(given, error) && access(given, W_OK) == 0) return given;
  return fs::temp_directory_path();
}

}  // namespace

Result<RunFolder> RunFolder::make(const std::string& run) {
  if (!is_plain(run))
    return Error{"--run '" + run + "': expected letters, digits, _ and -, at most 64"};
  const fs::path path = runtime_folder() / ("galilean-" + run);
  if (auto made = make_private_folder(path); !made)
    return Error{made.error().message + "; choose another --run"};
  const auto opened = open_private_file(path / "lock", O_RDWR | O_NOFOLLOW);
  if (!opened) return Error{opened.error().message + "; choose another --run"};
  const int lock = opened.value();
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) return RunFolder(path, lock);
  close(lock);
  return Error{"run '" + run + "' is already simulated; end that one, or choose another --run"};
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

RunFolder::~RunFolder() {
  if (lock_ < 0) return;
  std::error_code error;
  fs::remove_all(path_, error);
  close(lock_);
}

}  // namespace galilean::sim
