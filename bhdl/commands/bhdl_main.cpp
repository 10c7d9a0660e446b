// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "bhdl/check/describe.h"
#include "bhdl/commands/diff_command.h"
#include "bhdl/commands/format_command.h"
#include "bhdl/commands/graph_command.h"
#include "bhdl/lsp/standard_streams.h"
#include "bhdl/program/catalog_file.h"
#include "bhdl/program/machine.h"
#include "core/command_line/command_line.h"
#include "core/installation.h"
#include "core/json_text.h"
#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean::bhdl {
namespace {

struct Options {
  std::string catalog_path = default_catalog_path().string();
  std::vector<std::string> files;
  std::string component;
  bool json = false;
  std::string graph_format = "dot";
  bool check_only = false;
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
    std::cout << visible(file) << ": ok, " << plural(result.program->states.size(), "state") << ", "
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
  std::cout << json_text(answer, 1) << '\n';
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

/// The commands of the command line.
struct Commands {
  CommandLine check;
  CommandLine describe;
  CommandLine format;
  CommandLine diff;
  CommandLine graph;
  CommandLine test;
  CommandLine language_server;
};

Commands add_commands(CommandLine& app, Options& options) {
  Commands commands{app.command("check", "Check programs; exits with 0 if none has errors"),
                    app.command("describe", "Print the components that programs can use"),
                    app.command("fmt", "Format files and print the names of those that changed"),
                    app.command("diff", "Print how two programs differ"),
                    app.command("graph", "Print a program's state machine"),
                    app.command("test", "Test the expectations of programs"),
                    app.command("lsp",
                                "Serve an editor over the Language Server Protocol, on stdin and "
                                "stdout")};
  const std::string program = ".bhdl";
  commands.check.option("FILE", options.files, "programs").required().names_file(program);
  commands.describe.option("COMPONENT", options.component, "one component, or state or condition");
  commands.format.option("FILE", options.files, "files, or - for standard input")
      .required()
      .names_file(program);
  commands.format.flag(
      "--check", options.check_only,
      "Write nothing, list the files that would change, and exit with 1 if there are any");
  commands.diff.option("FILE", options.files, "two programs")
      .required()
      .takes(2, 2)
      .names_file(program);
  commands.diff.footer("Exits 0 if they do the same, 1 if not, 2 if one of them is not a program.");
  commands.graph.option("FILE", options.files, "a program")
      .required()
      .takes(1, 1)
      .names_file(program);
  commands.diff.describe_exit(1, "The programs differ.");
  commands.diff.describe_exit(2, "One of the files is not a program.");
  commands.graph.option("--format", options.graph_format, "Format of the output")
      .one_of({"dot", "svg", "json"})
      .show_default();
  commands.test.option("FILE", options.files, "programs").required().names_file(program);
  for (auto* command : {&commands.check, &commands.describe, &commands.diff, &commands.test})
    command->flag("--json", options.json, "Print JSON");
  for (auto* command : {&commands.check, &commands.describe, &commands.diff, &commands.graph,
                        &commands.language_server})
    command
        ->option("--catalog", options.catalog_path,
                 "JSON file of the components (default: those of this build's robot)")
        .names_file(".json");
  commands.language_server.flag(
      "--stdio",
      "Accepted because some editors pass it: the server always uses standard input and output");
  return commands;
}

/// Becomes the program that tests, which has a robot's schemas. Returns only if it cannot.
int become_test(char** rest) {
  std::string program = (program_folder() / "galilean-bhdl-test").string();
  std::vector<char*> arguments{program.data()};
  for (; *rest; ++rest) arguments.push_back(*rest);
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  std::cerr << "galilean-bhdl: " << program << " cannot be started: " << std::strerror(errno)
            << '\n';
  return kFailed;
}

int run_language_server(const Catalog& catalog) {
  lsp::Server server(catalog, std::make_unique<lsp::DiskFolder>());
  return lsp::serve(server, STDIN_FILENO, STDOUT_FILENO);
}

int run(int argc, char** argv) {
  Options options;
  CommandLine app("Checks, formats, compares, draws and explains BHDL programs; serves editors.",
                  "galilean bhdl");
  app.require_command();
  const Commands commands = add_commands(app, options);
  const auto failure = [&] { return commands.diff.chosen() ? 2 : 1; };
  if (const auto code = app.parse(argc, argv)) return *code;
  if (commands.test.chosen()) return become_test(argv + 2);
  if (commands.format.chosen()) return run_format(options.files, options.check_only);
  const auto catalog = load_catalog(options.catalog_path);
  if (!catalog) {
    std::cerr << "galilean-bhdl: " << catalog.error().message << '\n';
    return failure();
  }
  if (commands.diff.chosen())
    return run_diff(options.files[0], options.files[1], options.json, catalog.value());
  if (commands.graph.chosen())
    return run_graph(options.files[0], options.graph_format, catalog.value());
  if (commands.language_server.chosen()) return run_language_server(catalog.value());
  return commands.check.chosen() ? run_check(options, catalog.value())
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
