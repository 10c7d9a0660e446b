// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/replace_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace galilean::bhdl {
namespace {

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool fill_beside(int descriptor, const std::string& path, std::string_view text) {
  struct stat old {};
  return ::stat(path.c_str(), &old) == 0 && ::fchmod(descriptor, old.st_mode & 07777) == 0 &&
         write_all(descriptor, text) && ::fsync(descriptor) == 0;
}

Error cannot_write(const std::string& path, const std::string& reason) {
  return {"cannot write '" + path + "': " + reason + "; it is as it was"};
}

}  // namespace

Result<void> replace_file(const std::filesystem::path& path, std::string_view text) {
  std::error_code failed;
  const std::string target = std::filesystem::canonical(path, failed).string();
  if (failed) return cannot_write(path.string(), failed.message());
  std::string beside = target + ".XXXXXX";
  const int descriptor = ::mkstemp(beside.data());
  if (descriptor < 0) return cannot_write(target, std::strerror(errno));
  const bool done = fill_beside(descriptor, target, text);
  int reason = errno;
  ::close(descriptor);
  if (done && ::rename(beside.c_str(), target.c_str()) == 0) return {};
  if (done) reason = errno;
  ::unlink(beside.c_str());
  return cannot_write(target, std::strerror(reason));
}

}  // namespace galilean::bhdl
