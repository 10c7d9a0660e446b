// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/loader.h"

#include <algorithm>
#include <optional>

#include "bhdl/source/readable.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/parser.h"

namespace galilean::bhdl {
namespace {

class Loader {
 public:
  Loader(const SourceProvider& sources, Diagnostics& diagnostics, const TreeReader& read)
      : sources_(sources), diagnostics_(diagnostics), read_(read) {}

  LoadedProgram load(const std::string& main_path) {
    add_file(normal_path(main_path), std::nullopt);
    return std::move(program_);
  }

 private:
  // The recursion ends at kDeepestInclude.
  void add_file(const std::string& path, const std::optional<Position>& include) {
    auto text = sources_.read(path, kMostFileBytes);
    if (!text) return refuse(path, include, text.error());
    bytes_ += text.value().size();
    program_.files.push_back({path, sources_.shown(path), std::move(text).value()});
    const LoadedFile& file = program_.files.back();
    being_read_.push_back(path);
    for (auto& node : read_(file, diagnostics_)) {
      if (const auto* inner = std::get_if<IncludeNode>(&node))
        follow(*inner, path);
      else
        program_.tree.push_back(std::move(node));
    }
    being_read_.pop_back();
  }

  void follow(const IncludeNode& include, const std::string& from) {
    const auto path = included_path(from, include.path.text);
    if (std::ranges::find(being_read_, path) != being_read_.end())
      return refuse_cycle(path, include.path.at);
    if (std::ranges::find(program_.files, path, &LoadedFile::path) != program_.files.end()) return;
    if (may_go_on(include.path.at)) add_file(path, include.path.at);
  }

  bool may_go_on(const Position& at) {
    const bool deep = being_read_.size() >= kDeepestInclude;
    const bool many = program_.files.size() >= kMostFiles || bytes_ >= kMostProgramBytes;
    if (deep)
      diagnostics_.error(
          at, "include/too-deep",
          "includes are nested more than " + std::to_string(kDeepestInclude) + " files deep here");
    else if (many && !told_too_many_)
      diagnostics_.error(at, "include/too-many",
                         "a program has at most " + std::to_string(kMostFiles) + " files and " +
                             std::to_string(kMostProgramBytes) + " bytes");
    told_too_many_ = told_too_many_ || many;
    return !deep && !many;
  }

  void refuse_cycle(const std::string& path, const Position& at) {
    std::string chain;
    for (auto each = std::ranges::find(being_read_, path); each != being_read_.end(); ++each)
      chain += in_quotes(*each) + " includes ";
    diagnostics_.error(at, "include/cycle", "a cycle of includes: " + chain + in_quotes(path));
  }

  void refuse(const std::string& path, const std::optional<Position>& include,
              const ReadFailure& why) {
    const std::string shown = sources_.shown(path);
    const bool missing = why.code == "file/not-found";
    if (include && missing)
      diagnostics_.error(*include, "include/not-found", why.message,
                         "the path is relative to the file that includes");
    else
      diagnostics_.error({shown, 1, 1}, why.code, why.message);
  }

  const SourceProvider& sources_;
  Diagnostics& diagnostics_;
  const TreeReader& read_;
  LoadedProgram program_;
  std::vector<std::string> being_read_;
  std::size_t bytes_ = 0;
  bool told_too_many_ = false;
};

}  // namespace

std::string included_path(const std::string& from, std::string_view include) {
  return normal_path(std::filesystem::path(from).parent_path() / std::string(include));
}

SyntaxTree read_tree(const LoadedFile& file, Diagnostics& diagnostics) {
  if (!is_readable(file.shown, file.text, diagnostics)) return {};
  return parse(file.shown, file.text, diagnostics);
}

LoadedProgram load(const std::string& main_path, const SourceProvider& sources,
                   Diagnostics& diagnostics, const TreeReader& read) {
  return Loader(sources, diagnostics, read).load(main_path);
}

}  // namespace galilean::bhdl
