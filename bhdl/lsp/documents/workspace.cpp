// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/workspace.h"

#include <algorithm>
#include <set>

#include "bhdl/lsp/documents/uri.h"
#include "bhdl/syntax/loader.h"

namespace galilean::bhdl::lsp {
namespace {

// When there are this many, all parsed files are dropped. Otherwise the files of programs that were
// looked at once would pile up.
constexpr std::size_t kMostParsed = 512;

bool holds(const ProgramFiles& program, const std::string& path) {
  return std::ranges::any_of(program, [&](const auto& file) { return file->path == path; });
}

}  // namespace

Workspace::Document* Workspace::find_open(const std::string& path) {
  const auto found = open_.find(path);
  return found == open_.end() ? nullptr : &found->second;
}

std::string Workspace::uri(const std::string& path) const {
  const auto found = open_.find(path);
  return found == open_.end() ? uri_of(path) : found->second.uri;
}

Result<std::string, ReadFailure> Workspace::read(const std::string& path,
                                                 std::size_t most_bytes) const {
  const auto found = open_.find(path);
  if (found == open_.end()) return folder_.read(path, most_bytes);
  const std::string& text = found->second.text;
  if (text.size() > most_bytes) return too_large(path, text.size(), most_bytes);
  return text;
}

FilePointer Workspace::file(const std::string& path) const {
  const auto found = parsed_.find(path);
  const FilePointer before = found == parsed_.end() ? nullptr : found->second;
  const auto open = open_.find(path);
  if (before != nullptr && open != open_.end() && before->text == open->second.text) return before;
  auto text = read(path, kMostProgramBytes);
  if (!text) return nullptr;
  if (before != nullptr && before->text == text.value()) return before;
  if (parsed_.size() >= kMostParsed) parsed_.clear();
  return parsed_[path] = std::make_shared<const ParsedFile>(path, std::move(text).value(),
                                                            vocabulary_, before.get());
}

FilePointer Workspace::file(const std::string& path, Read& read_before) const {
  const auto [entry, is_new] = read_before.try_emplace(path);
  if (is_new) entry->second = file(path);
  return entry->second;
}

ProgramFiles Workspace::program(const std::string& main_path) const {
  Read read_before;
  return program(main_path, read_before);
}

ProgramFiles Workspace::program(const std::string& main_path, Read& read_before) const {
  ProgramFiles files;
  std::set<std::string> met{main_path};
  std::vector<std::string> waiting{main_path};
  while (!waiting.empty() && files.size() < kMostFiles) {
    const FilePointer next = file(waiting.back(), read_before);
    waiting.pop_back();
    if (next == nullptr) continue;
    files.push_back(next);
    for (const auto& include : next->includes)
      if (met.insert(include).second) waiting.push_back(include);
  }
  return files;
}

std::vector<ProgramFiles> Workspace::programs_with(const std::string& path) const {
  Read read_before;
  std::set<std::string> candidates;
  for (const auto& each : open_) candidates.insert(each.first);
  for (auto& each : folder_.beside(path)) candidates.insert(std::move(each));
  std::vector<ProgramFiles> programs;
  std::set<std::string> included;
  for (const auto& main_path : candidates) {
    ProgramFiles files = program(main_path, read_before);
    for (std::size_t i = 1; i < files.size(); ++i) included.insert(files[i]->path);
    if (holds(files, path)) programs.push_back(std::move(files));
  }
  std::erase_if(programs, [&](const auto& files) { return included.contains(files[0]->path); });
  if (programs.empty()) programs.push_back(program(path, read_before));
  return programs;
}

}  // namespace galilean::bhdl::lsp
