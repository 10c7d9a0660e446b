// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/commands/graph_command.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "bhdl/graph/graph.h"
#include "bhdl/program/machine.h"
#include "core/json_text.h"

namespace galilean::bhdl {

int run_graph(const std::string& file, const std::string& format, const Catalog& catalog) {
  const CheckResult result = check_file(file, catalog);
  for (const auto& diagnostic : result.diagnostics) std::cerr << bhdl::format(diagnostic) << '\n';
  if (!result.program) return 1;
  if (format == "svg")
    std::cout << to_svg(*result.program);
  else if (format == "dot")
    std::cout << to_dot(*result.program);
  else
    std::cout << json_text(nlohmann::json(*result.program), 1) << '\n';
  return 0;
}

}  // namespace galilean::bhdl
