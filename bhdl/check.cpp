// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check.h"

#include "bhdl/check/checker.h"
#include "bhdl/lint/program_check.h"
#include "bhdl/source/readable.h"
#include "bhdl/source/sha256.h"
#include "bhdl/syntax/parser.h"

namespace galilean::bhdl {
namespace {

std::vector<std::string> shown_names(const std::deque<LoadedFile>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.shown);
  return names;
}

/// Reports what cannot be read, and leaves mistakes in the text to a later check.
SyntaxTree read_tree_alone(const LoadedFile& file, Diagnostics& diagnostics) {
  if (!is_readable(file.shown, file.text, diagnostics)) return {};
  Diagnostics for_the_check;
  return parse(file.shown, file.text, for_the_check);
}

std::vector<SourceFile> source_files(std::deque<LoadedFile>& loaded) {
  std::vector<SourceFile> files;
  for (auto& file : loaded) files.push_back({std::move(file.path), std::move(file.text)});
  return files;
}

CheckedTree check_loaded(SyntaxTree tree, const std::string& main_file,
                         const Vocabulary& vocabulary, Depth depth, Diagnostics& diagnostics) {
  CheckedTree checked = check_tree(std::move(tree), main_file, vocabulary, diagnostics);
  if (depth == Depth::kErrorsAndWarnings && !diagnostics.has_errors())
    warn_of_suspects(checked.program, vocabulary,
                     {checked.tree, checked.extended, checked.unused_constants, main_file},
                     diagnostics);
  return checked;
}

}  // namespace

CheckResult check(const std::string& main_path, const SourceProvider& sources,
                  const Vocabulary& vocabulary, Depth depth) {
  Diagnostics diagnostics;
  LoadedProgram loaded = load(main_path, sources, diagnostics);
  CheckResult result;
  CheckedTree checked = check_loaded(std::move(loaded.tree), sources.shown(main_path), vocabulary,
                                     depth, diagnostics);
  const bool usable = !diagnostics.has_errors();
  result.diagnostics = std::move(diagnostics).take(shown_names(loaded.files));
  result.files = source_files(loaded.files);
  if (!usable) return result;
  Program& program = checked.program;
  program.name = std::filesystem::path(main_path).filename().string();
  program.hash = program_hash(result.files);
  program.files = result.files;
  result.program = std::move(program);
  return result;
}

CheckResult check(const std::string& main_path, const SourceProvider& sources,
                  const Catalog& catalog) {
  return check(main_path, sources, Vocabulary(catalog));
}

std::vector<Diagnostic> diagnose(const std::string& main_path, const SourceProvider& sources,
                                 const TreeReader& read, const Vocabulary& vocabulary) {
  Diagnostics diagnostics;
  LoadedProgram loaded = load(main_path, sources, diagnostics, read);
  const CheckedTree checked = check_loaded(std::move(loaded.tree), sources.shown(main_path),
                                           vocabulary, Depth::kErrorsAndWarnings, diagnostics);
  return std::move(diagnostics).take(shown_names(loaded.files));
}

CheckResult check(std::vector<SourceFile> files, const Vocabulary& vocabulary) {
  if (files.empty()) {
    Diagnostic nothing;
    nothing.code = "file/none";
    nothing.message = "there is no file to check";
    return {std::nullopt, {nothing}, {}};
  }
  return check(normal_path(files.front().path), MemorySources(files), vocabulary);
}

CheckResult check(std::vector<SourceFile> files, const Catalog& catalog) {
  return check(std::move(files), Vocabulary(catalog));
}

Result<std::vector<SourceFile>, std::vector<Diagnostic>> read_program(
    const std::filesystem::path& path) {
  Diagnostics diagnostics;
  LoadedProgram loaded =
      load(path.filename().string(), DiskSources(path.parent_path()), diagnostics, read_tree_alone);
  if (diagnostics.has_errors()) return std::move(diagnostics).take(shown_names(loaded.files));
  return source_files(loaded.files);
}

CheckResult check_file(const std::filesystem::path& path, const Vocabulary& vocabulary,
                       Depth depth) {
  return check(path.filename().string(), DiskSources(path.parent_path()), vocabulary, depth);
}

CheckResult check_file(const std::filesystem::path& path, const Catalog& catalog) {
  return check_file(path, Vocabulary(catalog));
}

std::vector<std::string> files_of(const std::filesystem::path& path) {
  Diagnostics unused;
  const auto folder = path.parent_path();
  const auto program = load(path.filename().string(), DiskSources(folder), unused);
  std::vector<std::string> paths{path.string()};
  for (const auto& file : program.files) paths.push_back((folder / file.path).string());
  return paths;
}

}  // namespace galilean::bhdl
