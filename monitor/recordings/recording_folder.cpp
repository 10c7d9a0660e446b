// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_folder.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/regular_file.h"
#include "core/visible_text.h"
#include "monitor/recordings/recording_name.h"

namespace galilean::monitor {
namespace {

/// Closes a descriptor unless it is released.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const noexcept { return number_; }
  [[nodiscard]] int release() noexcept { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Opens a file that lies in the folder, also where links lead to it. A kernel without openat2, or
/// a sandbox that forbids it, follows no link.
int open_beneath(int folder, const char* name) {
  // O_NONBLOCK: a pipe without a writer would otherwise keep the caller waiting.
  constexpr int kHow = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
  constexpr int kTries = 8;  // EAGAIN: something was renamed meanwhile
  open_how how{};
  how.flags = kHow;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  for (int i = 0; i < kTries; ++i) {
    const auto opened = static_cast<int>(syscall(SYS_openat2, folder, name, &how, sizeof how));
    if (opened >= 0) return opened;
    if (errno == ENOSYS || errno == EPERM) return openat(folder, name, kHow | O_NOFOLLOW);
    if (errno != EAGAIN && errno != EINTR) return -1;
  }
  return -1;
}

NotOpened not_opened(const std::string& name, int reason) {
  using Why = NotOpened::Why;
  const auto shown = "'" + visible(name) + "'";
  switch (reason) {
    case ENOENT:
    case ENOTDIR:
      return {Why::kNotThere, "There is no recording " + shown + " here."};
    case EXDEV:
    case ELOOP:
      return {Why::kNotThere, shown + " is a link that leads out of the folder of recordings."};
    case ENXIO:
      return {Why::kNoFile, shown + " is a socket, and no file."};
    case EACCES:
    case EPERM:
      return {Why::kForbidden, shown + " cannot be read: the monitor has no permission to."};
    default:
      return {Why::kUnreadable, shown + " cannot be read: " + std::strerror(reason) + "."};
  }
}

}  // namespace

Result<OpenedRecording, NotOpened> RecordingFolder::open(const std::string& name) const {
  if (const auto right = check_recording_name(name); !right)
    return NotOpened{NotOpened::Why::kNotThere, right.error().message};
  const Descriptor folder(::open(folder_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return not_opened(name, errno);
  Descriptor file(open_beneath(folder.get(), name.c_str()));
  if (file.get() < 0) return not_opened(name, errno);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) return not_opened(name, errno);
  if (!S_ISREG(status.st_mode))
    return NotOpened{
        NotOpened::Why::kNoFile,
        "'" + visible(name) + "' is " + what_is_no_file(status.st_mode) + ", and no file."};
  constexpr std::uint64_t kSecond_ns = 1'000'000'000;
  return OpenedRecording{
      std::make_shared<const mcap::FileSource>(mcap::FileSource::of(file.release())),
      static_cast<std::uint64_t>(status.st_size),
      static_cast<std::uint64_t>(status.st_mtim.tv_sec) * kSecond_ns +
          static_cast<std::uint64_t>(status.st_mtim.tv_nsec),
      status.st_ino};
}

Result<std::vector<std::string>> RecordingFolder::names() const {
  namespace fs = std::filesystem;
  std::error_code failed;
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed))
    if (auto name = at->path().filename().string(); is_listed_name(name))
      names.push_back(std::move(name));
  if (failed && failed != std::errc::no_such_file_or_directory)
    return Error{"The folder of recordings, " + folder_.string() +
                 ", cannot be read: " + failed.message() + "."};
  std::ranges::sort(names);
  return names;
}

}  // namespace galilean::monitor
