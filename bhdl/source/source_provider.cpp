// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/source_provider.h"

#include <utility>

#include "bhdl/source/text.h"
#include "core/regular_file.h"

namespace galilean::bhdl {
namespace {

namespace fs = std::filesystem;

ReadFailure not_found(const std::string& path, const std::string& reason) {
  return {"file/not-found", "cannot read " + in_quotes(path) + ": " + reason};
}

}  // namespace

ReadFailure too_large(const std::string& path, std::uintmax_t bytes, std::size_t most_bytes) {
  return {"file/too-large", in_quotes(path) + " has " + std::to_string(bytes) +
                                " bytes; a BHDL file has at most " + std::to_string(most_bytes)};
}

std::string normal_path(const fs::path& path) {
  return path.lexically_normal().generic_string();
}

std::string DiskSources::shown(const std::string& path) const {
  return (folder_ / path).generic_string();
}

Result<std::string, ReadFailure> DiskSources::read(const std::string& path,
                                                   std::size_t most_bytes) const {
  const fs::path place = folder_ / path;
  std::error_code unknown;
  const auto size = fs::file_size(place, unknown);
  if (!unknown && size > most_bytes) return too_large(shown(path), size, most_bytes);
  auto text = read_regular_file(place.string(), most_bytes);
  if (!text) return not_found(shown(path), text.error().message);
  return std::move(text).value();
}

MemorySources::MemorySources(const std::vector<SourceFile>& files) {
  for (const auto& file : files) files_.try_emplace(normal_path(file.path), &file);
}

Result<std::string, ReadFailure> MemorySources::read(const std::string& path,
                                                     std::size_t most_bytes) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return not_found(path, "it is not among the files that were sent");
  const std::string& text = found->second->text;
  if (text.size() > most_bytes) return too_large(path, text.size(), most_bytes);
  return text;
}

}  // namespace galilean::bhdl
