#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/catalog_file.h"
#include "bhdl/check.h"
#include "bhdl/describe.h"
#include "bhdl/machine.h"

namespace galilean::bhdl {
namespace {

struct Options {
  std::string catalog_path = default_catalog_path().string();
  std::vector<std::string> files;
  std::string component;
  bool json = false;
};

nlohmann::json check_to_json(const std::string& file, const CheckResult& result) {
  nlohmann::json json{
      {"file", file}, {"ok", result.program.has_value()}, {"diagnostics", result.diagnostics}};
  if (result.program) json["program"] = *result.program;
  return json;
}

void print_check(const std::string& file, const CheckResult& result) {
  for (const auto& diagnostic : result.diagnostics) std::cerr << format(diagnostic) << '\n';
  if (result.program)
    std::cout << file << ": ok, " << result.program->states.size() << " states, "
              << result.program->hash.substr(0, 12) << '\n';
}

int run_check(const Options& options, const Catalog& catalog) {
  bool all_ok = true;
  nlohmann::json programs = nlohmann::json::array();
  for (const auto& file : options.files) {
    const CheckResult result = check_file(file, catalog);
    all_ok = all_ok && result.program.has_value();
    if (options.json)
      programs.push_back(check_to_json(file, result));
    else
      print_check(file, result);
  }
  if (!options.json) return all_ok ? 0 : 1;
  nlohmann::json diagnostics = nlohmann::json::array();
  for (const auto& program : programs)
    for (const auto& diagnostic : program["diagnostics"]) diagnostics.push_back(diagnostic);
  const nlohmann::json answer{{"ok", all_ok}, {"diagnostics", diagnostics}, {"programs", programs}};
  std::cout << answer.dump(1) << '\n';
  return all_ok ? 0 : 1;
}

int run_describe(const Options& options, const Catalog& catalog) {
  if (!options.json && options.component.empty()) {
    std::cout << describe(catalog);
    return 0;
  }
  const auto text = options.json ? describe_json(catalog, options.component)
                                 : describe(catalog, options.component);
  if (!text) {
    std::cerr << "galilean-bhdl: " << text.error().message << '\n';
    return 1;
  }
  std::cout << text.value() << (options.json ? "\n" : "");
  return 0;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Checks BHDL programs and prints the reference of the language.", "galilean bhdl");
  app.require_subcommand(1);
  auto* check = app.add_subcommand("check", "Check programs; exits 0 if all of them are right");
  check->add_option("FILE", options.files, "programs")->required();
  auto* describe = app.add_subcommand("describe", "Print what programs can name");
  describe->add_option("COMPONENT", options.component, "one component, or state or condition");
  for (auto* command : {check, describe}) {
    command->add_flag("--json", options.json, "Print JSON");
    command->add_option("--catalog", options.catalog_path,
                        "What components there are (default: this build's robot)");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : 1;
  }
  const auto catalog = load_catalog(options.catalog_path);
  if (!catalog) {
    std::cerr << "galilean-bhdl: " << catalog.error().message << '\n';
    return 1;
  }
  return check->parsed() ? run_check(options, catalog.value())
                         : run_describe(options, catalog.value());
}

}  // namespace
}  // namespace galilean::bhdl

int main(int argc, char** argv) {
  try {
    return galilean::bhdl::run(argc, argv);
  } catch (const std::exception& problem) {
    std::cerr << "galilean-bhdl: " << problem.what() << '\n';
    return 1;
  }
}
