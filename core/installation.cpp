// SPDX-License-Identifier: BSD-3-Clause
#include "core/installation.h"

namespace galilean {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::current_path(error) : program.parent_path();
}

fs::path shipped(const std::string& name) {
  return program_folder().parent_path() / "share" / "galilean" / name;
}

fs::path find_file(const std::string& name_or_path, const std::string& room,
                   const std::string& extension) {
  const fs::path path = name_or_path;
  std::error_code error;
  if (path.has_parent_path() || fs::exists(path, error)) return path;
  fs::path candidate = shipped(room) / path;
  if (candidate.extension() != extension) candidate += extension;
  return fs::exists(candidate, error) || path.extension() != extension ? candidate : path;
}

}  // namespace galilean
