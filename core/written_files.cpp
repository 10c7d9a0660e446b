// SPDX-License-Identifier: BSD-3-Clause
#include "core/written_files.h"

#include <filesystem>
#include <system_error>

namespace galilean {
namespace {

namespace fs = std::filesystem;

/// Returns the path without links and without needless parts, as far as it is there. A link to a
/// file that is not there yet is followed, too, since writing follows it.
fs::path place_of(fs::path path) {
  constexpr int kMostLinks = 40;  // as the kernel
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    const auto target = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  auto place = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path.lexically_normal() : place;
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code unknown;
  return fs::equivalent(a, b, unknown) || place_of(a) == place_of(b);
}

void remove_unfinished(const std::string& path) noexcept {
  std::error_code unknown;
  if (fs::is_regular_file(path, unknown)) fs::remove(path, unknown);
}

Result<void> check_written_files(const std::vector<std::string>& written,
                                 const std::vector<std::string>& read) {
  for (auto each = written.begin(); each != written.end(); ++each) {
    std::error_code unknown;
    if (*each == "-")
      return Error{"'-' stands for standard output, which is not written here; name a file"};
    if (each->empty() || fs::is_other(*each, unknown)) continue;
    for (const auto& other : read)
      if (is_same_file(*each, other))
        return Error{*each + " is read here and cannot be written; choose another name"};
    for (auto other = written.begin(); other != each; ++other)
      if (is_same_file(*each, *other))
        return Error{*each + " would be written twice; choose another name for one of the files"};
  }
  return {};
}

}  // namespace galilean
