// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "core/command_line/command_line.h"
#include "core/json_text.h"
#include "robot/components.h"
#include "robot/rehearsal/rehearsal.h"

namespace galilean::robot {
namespace {

struct Outcome {
  bool checked = true;
  std::vector<bhdl::Diagnostic> diagnostics;
  std::vector<ExpectationOutcome> verdicts;

  [[nodiscard]] bool passed() const {
    return checked && std::ranges::all_of(verdicts, &ExpectationOutcome::passed);
  }
};

Outcome test(const std::string& file, const Catalog& catalog) {
  const auto checked = bhdl::check_file(file, catalog);
  Outcome outcome{.checked = checked.program.has_value(), .diagnostics = checked.diagnostics};
  if (!checked.program) return outcome;
  for (const auto& expectation : checked.program->expectations)
    outcome.verdicts.push_back(rehearse(*checked.program, expectation));
  return outcome;
}

void print(const std::string& file, const Outcome& outcome) {
  for (const auto& each : outcome.diagnostics) std::cerr << bhdl::format(each) << '\n';
  for (const auto& each : outcome.verdicts) std::cout << in_words(each);
  if (outcome.checked && outcome.verdicts.empty())
    std::cout << file << " has no expectations; add one with `expect:`\n";
}

int run(int argc, char** argv) {
  std::vector<std::string> files;
  bool as_json = false;
  CommandLine app(
      "Tests the expectations of programs without a robot; exits with 0 if all come true.",
      "galilean bhdl test");
  app.option("FILE", files, "programs").required().names_file(".bhdl");
  app.flag("--json", as_json, "Print JSON");
  if (const auto code = app.parse(argc, argv)) return *code;
  Registry components;
  add_components(components);
  bool passed = true;
  nlohmann::json programs = nlohmann::json::array();
  for (const auto& file : files) {
    const Outcome outcome = test(file, components.catalog());
    passed = passed && outcome.passed();
    if (as_json)
      programs.push_back({{"file", file},
                          {"ok", outcome.passed()},
                          {"diagnostics", outcome.diagnostics},
                          {"expectations", outcome.verdicts}});
    else
      print(file, outcome);
  }
  if (as_json)
    std::cout << json_text(nlohmann::json{{"ok", passed}, {"programs", programs}}, 1) << '\n';
  return passed ? 0 : 1;
}

}  // namespace
}  // namespace galilean::robot

int main(int argc, char** argv) {
  try {
    return galilean::robot::run(argc, argv);
  } catch (const std::exception& problem) {
    std::cerr << "galilean-bhdl-test: " << problem.what() << '\n';
    return 1;
  }
}
