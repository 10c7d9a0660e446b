// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/programs.h"

#include "core/installation.h"

namespace galilean::sim {

Result<bhdl::Program> load_program(const std::string& name_or_path, const Catalog& catalog) {
  const auto path = find_file(name_or_path, "programs", ".bhdl");
  bhdl::CheckResult result = bhdl::check_file(path, catalog);
  if (result.program) return std::move(*result.program);
  std::string lines;
  for (const auto& diagnostic : result.diagnostics)
    lines += (lines.empty() ? "" : "\n") + bhdl::format(diagnostic);
  return Error{lines};
}

}  // namespace galilean::sim
