// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/program_folder.h"

#include <algorithm>

#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace fs = std::filesystem;

// A path that does not begin with a slash is an editor's unsaved document, which has no file.
fs::path DiskFolder::place_of(const std::string& path) const {
  if (!path.starts_with('/')) return {};
  return root_ / fs::path(normal_path(path)).relative_path();
}

Result<std::string, ReadFailure> DiskFolder::read(const std::string& path,
                                                  std::size_t most_bytes) const {
  const fs::path place = place_of(path);
  if (place.empty())
    return ReadFailure{"file/not-found", in_quotes(path) + " was never saved: save it first"};
  return DiskSources("").read(place.string(), most_bytes);
}

std::vector<std::string> DiskFolder::beside(const std::string& path) const {
  std::vector<std::string> paths;
  const fs::path folder = fs::path(path).parent_path();
  std::error_code failed;
  const fs::path place = place_of(folder.string());
  if (place.empty()) return paths;
  constexpr std::size_t kMostEntries = 4096;
  std::size_t entries = 0;
  for (fs::directory_iterator at(place, failed), end;
       !failed && at != end && entries < kMostEntries; at.increment(failed), ++entries)
    if (at->path().extension() == ".bhdl")
      paths.push_back((folder / at->path().filename()).generic_string());
  std::ranges::sort(paths);
  if (paths.size() > kMostBeside) paths.resize(kMostBeside);
  return paths;
}

}  // namespace galilean::bhdl::lsp
