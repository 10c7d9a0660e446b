// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/commands/diff_command.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "bhdl/diff/diff.h"
#include "core/json_text.h"

namespace galilean::bhdl {
namespace {

// Warnings are not printed, because they would hide the difference. `galilean bhdl check` prints
// them.
std::optional<Program> program_to_compare(const std::string& file, const Catalog& catalog) {
  CheckResult result = check_file(file, catalog);
  if (!result.program)
    for (const auto& diagnostic : result.diagnostics) std::cerr << format(diagnostic) << '\n';
  return std::move(result.program);
}

nlohmann::json end_to_json(const std::string& file, const Program& program) {
  return {{"file", file}, {"hash", program.hash}};
}

}  // namespace

int run_diff(const std::string& from, const std::string& to, bool json, const Catalog& catalog) {
  const auto before = program_to_compare(from, catalog);
  const auto after = program_to_compare(to, catalog);
  if (!before || !after) return 2;
  const auto changes = differences(*before, *after, catalog);
  if (json) {
    const nlohmann::json answer{{"same", changes.empty()},
                                {"from", end_to_json(from, *before)},
                                {"to", end_to_json(to, *after)},
                                {"changes", changes}};
    std::cout << json_text(answer, 1) << '\n';
  } else {
    for (const auto& change : changes) std::cout << in_words(change) << '\n';
  }
  return changes.empty() ? 0 : 1;
}

}  // namespace galilean::bhdl
