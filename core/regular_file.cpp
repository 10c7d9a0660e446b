// SPDX-License-Identifier: BSD-3-Clause
#include "core/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace galilean {
namespace {

Result<void> regular(int failed, const struct stat& status) {
  if (failed != 0) return Error{std::strerror(errno)};
  const auto kind = what_is_no_file(status.st_mode);
  if (!kind.empty()) return Error{"it is " + kind + ", and no file"};
  return {};
}

/// Reads up to the end, or until there are more than `most_bytes` bytes.
Result<std::string> read_all(int descriptor, std::uintmax_t most_bytes) {
  std::string text;
  std::array<char, 65536> piece{};
  while (text.size() <= most_bytes) {
    const auto count = read(descriptor, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Error{std::strerror(errno)};
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
  return Error{"it has more than " + std::to_string(most_bytes) + " bytes"};
}

}  // namespace

std::string what_is_no_file(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

Result<int> open_regular_file(const std::string& path) {
  struct stat status {};
  if (auto right = regular(stat(path.c_str(), &status), status); !right) return right.error();
  // It may have become something else meanwhile, for which nobody must wait either.
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) return Error{std::strerror(errno)};
  if (auto right = regular(fstat(descriptor, &status), status); !right) {
    close(descriptor);
    return right.error();
  }
  return descriptor;
}

Result<std::string> read_regular_file(const std::string& path, std::uintmax_t most_bytes) {
  const auto opened = open_regular_file(path);
  if (!opened) return opened.error();
  auto text = read_all(opened.value(), most_bytes);
  close(opened.value());
  return text;
}

}  // namespace galilean
