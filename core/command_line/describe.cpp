// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/describe.h"

#include <CLI/CLI.hpp>
#include <string_view>

namespace galilean {
namespace {

std::vector<const CLI::App*> commands_in(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Returns nullptr if there is no such command.
const CLI::App* command_named(std::string_view name, const CLI::App& app) {
  for (const auto* command : commands_in(app))
    if (command->get_name() == name) return command;
  return nullptr;
}

std::vector<std::string> names_of_option(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const auto& name : option.get_snames()) names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Returns what the value is called, without the demands on it, which CLI11 puts behind a colon.
std::string value_name(const CLI::Option& option, const ValueFiles& files) {
  if (option.get_items_expected_max() == 0) return {};
  if (files.kind == ValueFiles::Kind::kFile) return "FILE";
  if (files.kind == ValueFiles::Kind::kFolder) return "FOLDER";
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

OptionDescription describe(const CLI::Option& option, const OptionNotes& notes) {
  OptionDescription told;
  told.names = names_of_option(option);
  if (told.names.empty()) told.argument = option.get_single_name();
  told.help = option.get_description();
  told.value = value_name(option, notes.files);
  told.range = notes.range;
  told.default_value = notes.default_value.empty() ? option.get_default_str() : notes.default_value;
  told.choices = notes.choices;
  told.examples = notes.examples;
  told.files = notes.files;
  told.required = option.get_required();
  told.least_values = option.get_items_expected_min();
  told.most_values = option.get_items_expected_max();
  return told;
}

std::string full_name(const CLI::App& app) {
  const CLI::App* outer = app.get_parent();
  return outer ? full_name(*outer) + ' ' + app.get_name() : app.get_name();
}

}  // namespace

CommandDescription describe(const CLI::App& app, const CommandLineNotes& notes) {
  CommandDescription told;
  told.name = full_name(app);
  told.help = app.get_description();
  told.footer = app.get_footer();
  told.takes_outer_options = app.get_parent() != nullptr && app.get_fallthrough();
  told.requires_command = app.get_require_subcommand_min() > 0;
  for (const auto* option : app.get_options()) {
    const auto noted = notes.options.find(option);
    told.options.push_back(
        describe(*option, noted == notes.options.end() ? OptionNotes{} : noted->second));
  }
  for (const auto* command : commands_in(app)) told.commands.push_back(describe(*command, notes));
  if (const auto codes = notes.exit_codes.find(&app); codes != notes.exit_codes.end())
    told.exit_codes = codes->second;
  return told;
}

std::optional<CommandDescription> asked_description(const CLI::App& app,
                                                    const CommandLineNotes& notes, int count,
                                                    const char* const* arguments) {
  if (count < 2 || arguments[count - 1] != std::string_view(kDescribeCommandLine))
    return std::nullopt;
  const CLI::App* asked = &app;
  for (int i = 1; i < count - 1 && asked; ++i) asked = command_named(arguments[i], *asked);
  if (!asked) return std::nullopt;
  return describe(*asked, notes);
}

}  // namespace galilean
