#include "bhdl/check.h"

#include "bhdl/checker.h"
#include "bhdl/loader.h"
#include "bhdl/sha256.h"

namespace galilean::bhdl {
namespace {

std::vector<std::string> shown_names(const std::deque<LoadedFile>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.shown);
  return names;
}

CheckResult check_sources(const std::string& main_path, const SourceProvider& sources,
                          const Catalog& catalog) {
  Diagnostics diagnostics;
  LoadedProgram loaded = load(main_path, sources, diagnostics);
  CheckResult result;
  Program program =
      check_tree(std::move(loaded.tree), sources.shown(main_path), catalog, diagnostics);
  const bool usable = !diagnostics.has_errors();
  result.diagnostics = std::move(diagnostics).take(shown_names(loaded.files));
  for (auto& file : loaded.files)
    result.files.push_back({std::move(file.path), std::move(file.text)});
  if (!usable) return result;
  program.name = std::filesystem::path(main_path).filename().string();
  program.hash = program_hash(result.files);
  program.files = result.files;
  result.program = std::move(program);
  return result;
}

}  // namespace

CheckResult check(std::vector<SourceFile> files, const Catalog& catalog) {
  if (files.empty()) {
    Diagnostic nothing;
    nothing.code = "file/none";
    nothing.message = "there is no file to check";
    return {std::nullopt, {nothing}, {}};
  }
  return check_sources(normal_path(files.front().path), MemorySources(files), catalog);
}

CheckResult check_file(const std::filesystem::path& path, const Catalog& catalog) {
  return check_sources(path.filename().string(), DiskSources(path.parent_path()), catalog);
}

}  // namespace galilean::bhdl
