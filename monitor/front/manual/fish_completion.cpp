// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/completion.h"
#include "monitor/front/manual/places.h"

namespace galilean::front {
namespace {

constexpr const char* kFishFunctions = R"fish(
# Prints the commands that were given, and the number of the argument that follows.
function __galilean_place
    set -l given (commandline -opc)
    set -e given[1]
    set -l place ''
    set -l number 1
    set -l skip no
    for word in $given
        if string match -qr '^-[^0-9]' -- $word
            set skip no
            contains -- "$place $word" $__galilean_valued; and set skip yes
            continue
        end
        if test $skip = yes
            set skip no
            continue
        end
        set -l next (string trim -- "$place $word")
        if contains -- $next $__galilean_places
            set place $next
            set number 1
        else
            set number (math $number + 1)
        end
    end
    echo $place
    echo $number
end

# Whether the commands $argv[1] were given, and argument number $argv[2] follows, if that is named.
function __galilean_at
    set -l where (__galilean_place)
    test "$where[1]" = "$argv[1]"; or return 1
    test (count $argv) -lt 2; or test $where[2] = $argv[2]
end

# Offers the files whose names end in $argv[1], and folders.
function __galilean_files
    set -l typed (string replace -r '^--[^=]*=' '' -- (commandline -ct))
    set -l wanted '^[^\t]*(?:/|'(string escape --style=regex -- $argv[1])')(?:\t.*)?$'
    __fish_complete_path $typed | string match -r $wanted
end

complete -c galilean -f
)fish";

std::string in_fish(const std::string& text) {
  return quoted(text, R"(\')", "\\");
}

std::string condition(const Place& place, const std::string& number = {}) {
  const std::string at = "__galilean_at " + quoted(place.path, "'");
  return "complete -c galilean -n \"" + at + (number.empty() ? "" : " " + number) + "\"";
}

/// Returns what offers values, such as " -a 'dot svg json'".
std::string fish_values(const OptionDescription& option) {
  auto words = words_for(option);
  const auto& files = option.files;
  if (files.kind == ValueFiles::Kind::kFolder) words.emplace_back("(__fish_complete_directories)");
  if (files.kind == ValueFiles::Kind::kFile && !files.extension.empty())
    words.push_back("(__galilean_files " + files.extension + ")");
  std::string text;
  if (!words.empty()) text += " -a " + in_fish(joined(words));
  const bool any_file = files.kind == ValueFiles::Kind::kFile && files.extension.empty();
  text += any_file ? " -F" : " -f";
  return text;
}

std::string fish_option(const Place& place, const OptionDescription& option) {
  std::string text = condition(place);
  for (const auto& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.most_values > 0) text += " -r" + fish_values(option);
  return text + " -d " + in_fish(option.help) + "\n";
}

std::string fish_arguments(const Place& place) {
  std::string text;
  int number = 1;
  for (const auto& argument : place.arguments) {
    const std::string values = fish_values(argument);
    const bool endless = is_endless(argument);
    for (int i = 0; i < (endless ? 1 : argument.most_values); ++i, ++number)
      if (values != " -f")
        text += condition(place, endless ? "" : std::to_string(number)) + values + " -d " +
                in_fish(argument.help) + "\n";
  }
  return text;
}

std::string fish_commands(const Place& place) {
  std::string text;
  for (const auto* command : place.commands)
    text += condition(place) + " -a " + last_word(command->name) + " -d " + in_fish(command->help) +
            "\n";
  return text;
}

/// Returns a line that sets a list of texts.
std::string fish_list(const std::string& name, const std::vector<std::string>& texts) {
  std::string line = "set -g " + name;
  for (const auto& text : texts) line += ' ' + in_fish(text);
  return line + "\n";
}

}  // namespace

std::string fish_completion(const CommandDescription& tree) {
  std::vector<std::string> paths, valued;
  std::string rules;
  for (const auto& place : places_of(tree)) {
    if (!place.path.empty()) paths.push_back(place.path);
    for (const auto& option : place.options)
      for (const auto& name : option.names)
        if (option.most_values > 0) valued.push_back(place.path + ' ' + name);
    rules += fish_commands(place) + fish_arguments(place);
    for (const auto& option : place.options) rules += fish_option(place, option);
  }
  return "# fish completion of galilean, made by `galilean completion fish`\n" +
         fish_list("__galilean_places", paths) + fish_list("__galilean_valued", valued) +
         kFishFunctions + rules;
}

}  // namespace galilean::front
