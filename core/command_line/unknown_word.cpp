// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/unknown_word.h"

#include <CLI/CLI.hpp>

#include "core/spelling.h"

namespace galilean {
namespace {

using Names = std::vector<std::string_view>;

/// Returns the app and those of its commands that were given, from the outermost on.
std::vector<const CLI::App*> given_commands(const CLI::App& app) {
  std::vector<const CLI::App*> given{&app};
  while (!given.back()->get_subcommands().empty())
    given.push_back(given.back()->get_subcommands().front());
  return given;
}

Names long_options(const std::vector<const CLI::App*>& commands) {
  Names names;
  for (const auto* command : commands)
    for (const auto* option : command->get_options())
      names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

Names commands_of(const CLI::App& app) {
  Names names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string in_words(const std::string& what, const std::string& meant) {
  return "there is no " + what + (meant.empty() ? "" : "; did you mean '" + meant + "'?");
}

std::string unknown_option(const std::string& word, const Names& names) {
  const std::string option = word.substr(0, word.find('='));
  const auto name = option.find_first_not_of('-');
  const std::string meant = name == option.npos ? "" : meant_name(option.substr(name), names);
  return in_words("option '" + option + "'", meant.empty() ? meant : "--" + meant);
}

bool is_option(std::string_view word) {
  return word.starts_with('-') && word.find_first_not_of('-') != word.npos;
}

}  // namespace

std::optional<std::string> unknown_word(const CLI::App& app) {
  const auto given = given_commands(app);
  for (const auto* command : given) {
    const auto unknown = command->remaining();
    if (unknown.empty()) continue;
    const std::string& word = unknown.front();
    if (is_option(word)) return unknown_option(word, long_options(given));
    const Names commands = commands_of(*given.back());
    if (commands.empty()) return "'" + word + "' is one word too many";
    return in_words("command '" + word + "'", meant_name(word, commands));
  }
  return std::nullopt;
}

}  // namespace galilean
