// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monitor/front/manual/completion.h"
#include "monitor/front/manual/places.h"

namespace galilean::front {
namespace {

constexpr const char* kZshHead = R"zsh(#compdef galilean
# zsh completion of galilean, made by `galilean completion zsh`

# Offers the words of $1, and the files that match $2.
_galilean_words_or_files() {
  _alternative "words:value:($1)" "files:file:_files -g '$2'"
}

# Offers the commands that its caller lists.
_galilean_commands() {
  _describe command inner
}
)zsh";

std::string in_zsh(const std::string& text) {
  return quoted(text, R"('\'')");
}

/// Returns a text for between the brackets or colons of a specification that _arguments reads.
std::string specified(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view(R"(\[]:)").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// Returns the function that completes behind the commands `path`.
std::string function_of(std::string path) {
  std::ranges::replace(path, ' ', '_');
  std::ranges::replace(path, '-', '_');
  return "_galilean_at_" + path;
}

/// Returns ":VALUE:ACTION", by which _arguments offers values.
std::string action(const OptionDescription& option) {
  const auto words = words_for(option);
  const std::string files = "*" + option.files.extension;
  std::string action = " ";
  if (option.files.kind == ValueFiles::Kind::kFolder)
    action = "_files -/";
  else if (option.files.kind == ValueFiles::Kind::kFile && words.empty())
    action = "_files -g \"" + files + "\"";
  else if (option.files.kind == ValueFiles::Kind::kFile)
    action = " _galilean_words_or_files \"" + joined(words) + "\" \"" + files + "\"";
  else if (!words.empty())
    action = "(" + joined(words) + ")";
  return ":" + specified(option.names.empty() ? option.argument : option.value) + ":" + action;
}

/// Returns the specification of an option without its name: what it says and takes.
std::string specification(const OptionDescription& option) {
  const std::string help = "[" + specified(option.help) + "]";
  return option.most_values > 0 ? help + action(option) : help;
}

std::string option_lines(const OptionDescription& option) {
  std::string text;
  const std::string repeats = is_endless(option) ? "*" : "(" + joined(option.names) + ")";
  for (const auto& name : option.names) {
    const bool joins = option.most_values > 0 && name.starts_with("--");
    text += "    " + in_zsh(repeats + name + (joins ? "=" : "") + specification(option)) + " \\\n";
  }
  return text;
}

std::string argument_lines(const std::vector<OptionDescription>& arguments) {
  std::string text;
  int number = 1;
  for (const auto& argument : arguments) {
    if (is_endless(argument)) {
      text += "    " + in_zsh("*" + action(argument)) + " \\\n";
      continue;
    }
    for (int i = 0; i < argument.most_values; ++i)
      text += "    " + in_zsh(std::to_string(number++) + action(argument)) + " \\\n";
  }
  return text;
}

/// Returns the end of a function behind which further commands may stand.
std::string command_lines(const Place& place) {
  std::string branches;
  for (const auto* command : place.commands) {
    const std::string name = last_word(command->name);
    branches += "    " + name + ") " +
                function_of(place.path + (place.path.empty() ? "" : " ") + name) + " ;;\n";
  }
  return "    ':: :_galilean_commands' '*::: :->inner'\n"
         "  [[ $state == inner ]] || return\n"
         "  words=($line[1] \"${words[@]}\")\n  ((CURRENT += 1))\n  case $line[1] in\n" +
         branches + "  esac\n}\n";
}

std::string declared_commands(const Place& place) {
  std::string text = "  local -a inner=(\n";
  for (const auto* command : place.commands)
    text += "    " + in_zsh(specified(last_word(command->name)) + ":" + command->help) + "\n";
  return text + "  )\n";
}

std::string zsh_function(const Place& place) {
  std::string text = "\n" + function_of(place.path) + "() {\n";
  const bool has_commands = !place.commands.empty();
  text += "  local context state state_descr line\n  typeset -A opt_args\n";
  if (has_commands) text += declared_commands(place);
  text += has_commands ? "  _arguments -C \\\n" : "  _arguments \\\n";
  for (const auto& option : place.options) text += option_lines(option);
  if (!has_commands) text += argument_lines(place.arguments);
  return text + (has_commands ? command_lines(place) : "    && return\n}\n");
}

}  // namespace

std::string zsh_completion(const CommandDescription& tree) {
  std::string text = kZshHead;
  for (const auto& place : places_of(tree)) text += zsh_function(place);
  return text + "\n_galilean() {\n  " + function_of("") + "\n}\n\n_galilean \"$@\"\n";
}

}  // namespace galilean::front
