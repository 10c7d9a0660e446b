// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/programs/library.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "bhdl/source/source_provider.h"
#include "bhdl/syntax/loader.h"
#include "core/installation.h"

namespace galilean::monitor {
namespace fs = std::filesystem;

std::vector<std::string> ProgramLibrary::names() const {
  std::vector<std::string> result;
  std::error_code failed;
  for (fs::recursive_directory_iterator at(folder_, failed), end; !failed && at != end;
       at.increment(failed))
    if (at->is_regular_file(failed) && at->path().extension() == ".bhdl")
      result.push_back(at->path().lexically_relative(folder_).generic_string());
  std::ranges::sort(result);
  return result;
}

std::vector<LibraryEntry> ProgramLibrary::list() const {
  std::vector<LibraryEntry> result;
  std::set<std::string> included;
  for (const auto& name : names()) {
    const auto checked = bhdl::check(files_of(name), catalog_);
    for (std::size_t i = 1; i < checked.files.size(); ++i) included.insert(checked.files[i].path);
    result.push_back({name, checked.program ? checked.program->hash : std::string()});
  }
  std::erase_if(result, [&](const LibraryEntry& entry) {
    return entry.hash.empty() && included.contains(entry.name);
  });
  return result;
}

std::vector<bhdl::SourceFile> ProgramLibrary::files_of(const std::string& name) const {
  auto files = bhdl::check_file(folder_ / name, catalog_).files;
  const auto folder = fs::path(name).parent_path();
  for (auto& file : files) file.path = bhdl::normal_path(folder / file.path);
  return files;
}

std::optional<std::vector<bhdl::SourceFile>> ProgramLibrary::read(const std::string& name) const {
  const auto known = names();
  if (std::ranges::find(known, name) == known.end()) return std::nullopt;
  return files_of(name);
}

bhdl::CheckResult ProgramLibrary::check(std::vector<bhdl::SourceFile> files,
                                        const Catalog& catalog) const {
  if (files.empty()) return bhdl::check({}, catalog);
  const bhdl::DiskSources shipped(folder_);
  for (const auto& name : names()) {
    if (std::ranges::find(files, name, &bhdl::SourceFile::path) != files.end()) continue;
    if (auto text = shipped.read(name, bhdl::kMostFileBytes))
      files.push_back({name, std::move(text).value()});
  }
  return bhdl::check(std::move(files), catalog);
}

std::vector<TakenFile> ProgramLibrary::taken(const std::vector<bhdl::SourceFile>& sent,
                                             const bhdl::CheckResult& checked) const {
  std::set<std::string> known;
  for (const auto& file : sent) known.insert(bhdl::normal_path(file.path));
  std::vector<TakenFile> result;
  for (const auto& file : checked.files)
    if (!known.contains(file.path))
      result.push_back({file.path, (folder_ / file.path).generic_string()});
  return result;
}

void to_json(nlohmann::json& json, const TakenFile& file) {
  json = {{"path", file.path}, {"from", file.from}};
}

std::string in_words(const std::vector<TakenFile>& taken) {
  std::string files;
  for (const auto& file : taken) files += (files.empty() ? "" : ", ") + file.from;
  return files.empty() ? files
                       : "not sent with it, and taken from the monitor's programs: " + files;
}

fs::path default_library_folder() {
  return shipped("programs");
}

}  // namespace galilean::monitor
