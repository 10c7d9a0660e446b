#include "sim/programs.h"

#include <filesystem>

#include "sim/shipped_files.h"

namespace galilean::sim {

Result<bhdl::Program> load_program(const std::string& name_or_path, const Catalog& catalog) {
  const auto path = find_shipped(name_or_path, "programs", GALILEAN_PROGRAM_DIR, ".bhdl");
  bhdl::CheckResult result = bhdl::check_file(path, catalog);
  if (result.program) return std::move(*result.program);
  std::string lines;
  for (const auto& diagnostic : result.diagnostics)
    lines += (lines.empty() ? "" : "\n") + bhdl::format(diagnostic);
  return Error{lines};
}

}  // namespace galilean::sim
