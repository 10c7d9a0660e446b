// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/key_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/signing/trusted_keys.h"

namespace galilean {

std::string trust_line(const VerifyingKey& key, const std::string& name) {
  std::string shown = name;
  std::ranges::replace_if(
      shown, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return std::string(kKeyKind) + " " + key.text() + " " + shown + "\n";
}

std::optional<VerifyingKey> first_key_in(const std::filesystem::path& file) {
  const auto keys = TrustedKeys::load(file);
  if (!keys) return std::nullopt;
  return keys.value().all().front().key;
}

Result<void> write_new_file(const std::filesystem::path& file, const std::string& text,
                            mode_t mode) {
  const std::string draft = file.string() + "." + std::to_string(getpid());
  const auto cannot = [&file](int why) {
    return Error{file.string() + " cannot be written: " + std::strerror(why)};
  };
  const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor < 0) return cannot(errno);
  const bool is_written =
      write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
      fsync(descriptor) == 0;
  const int problem = errno;
  close(descriptor);
  // The link fails if the file is there. It holds the valid key then.
  const bool is_placed = is_written && (link(draft.c_str(), file.c_str()) == 0 || errno == EEXIST);
  const int link_problem = errno;
  unlink(draft.c_str());
  if (!is_written) return cannot(problem);
  if (!is_placed) return cannot(link_problem);
  return {};
}

}  // namespace galilean
