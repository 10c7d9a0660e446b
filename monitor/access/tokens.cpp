// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/tokens.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "core/regular_file.h"
#include "core/state_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kTokenBytes = 20;

Result<std::string> new_token() {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::array<unsigned char, kTokenBytes> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return Error{std::string("the system gives no random numbers: ") + std::strerror(errno)};
  std::string token;
  for (const auto byte : bytes) (token += kDigits[byte >> 4]) += kDigits[byte & 15];
  return token;
}

/// Writes the file whole or not at all, so that a crash never leaves half a token. Returns false,
/// with the reason in errno, if there is no such file afterwards.
bool write_secret(const fs::path& file, const std::string& token) {
  const fs::path draft = file.string() + "." + std::to_string(getpid());
  const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  const std::string text = token + "\n";
  const bool written =
      write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
      fsync(descriptor) == 0;
  const int problem = errno;
  close(descriptor);
  // The link fails if another monitor was quicker. Its token is the valid one then.
  const bool placed = written && (link(draft.c_str(), file.c_str()) == 0 || errno == EEXIST);
  if (!written) errno = problem;
  unlink(draft.c_str());
  return placed;
}

Result<std::string> read_or_make(const fs::path& file, bool& is_new) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) {
    const auto token = new_token();
    if (!token) return token.error();
    if (!write_secret(file, token.value()))
      return Error{file.string() + " cannot be written: " + std::strerror(errno) +
                   "; name a folder that can be written with --data DIR"};
    is_new = true;
  }
  return read_token(file);
}

}  // namespace

fs::path default_data_folder() {
  return state_folder();
}

fs::path operator_token_file(const fs::path& data_folder) {
  return data_folder / "operator.token";
}

Result<Tokens> open_tokens(const fs::path& data_folder) {
  std::error_code failed;
  fs::create_directories(data_folder, failed);
  Tokens tokens;
  auto viewer = read_or_make(data_folder / "viewer.token", tokens.are_new);
  if (!viewer) return viewer.error();
  auto operator_ = read_or_make(operator_token_file(data_folder), tokens.are_new);
  if (!operator_) return operator_.error();
  tokens.viewer = std::move(viewer).value();
  tokens.operator_ = std::move(operator_).value();
  return tokens;
}

Result<std::string> read_token(const fs::path& file) {
  constexpr std::size_t kShortest = 16, kMostBytes = 4096;
  const auto text = read_regular_file(file.string(), kMostBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  std::string token;
  std::istringstream(text.value()) >> token;
  if (token.size() < kShortest)
    return Error{file.string() + " has no token; remove it, and the monitor makes a new one"};
  return token;
}

}  // namespace galilean::monitor
