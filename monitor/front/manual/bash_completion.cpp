// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/completion.h"
#include "monitor/front/manual/places.h"

namespace galilean::front {
namespace {

constexpr const char* kBashHead =
    R"(# bash completion of galilean, made by `galilean completion bash`

# Offers the words of $1.
_galilean_words() {
  local word
  for word in $1; do [[ $word == "$cur"* ]] && COMPREPLY+=("$word"); done
}

# Offers the files whose names end in $1, which may be empty, and the folders on the way to them.
_galilean_files() {
  compopt -o filenames 2>/dev/null
  local name
  while IFS= read -r name; do
    [[ -d $name || $name == *"$1" ]] && COMPREPLY+=("$name")
  done < <(compgen -f -- "$cur")
}

_galilean_folders() {
  compopt -o filenames 2>/dev/null
  local name
  while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -d -- "$cur")
}
)";

constexpr const char* kBashTail = R"(
_galilean() {
  local cur=${COMP_WORDS[COMP_CWORD]} at=1 place='' number=1 owner='' word
  local commands options valued last
  COMPREPLY=()
  _galilean_place ''
  while ((at < COMP_CWORD)); do
    word=${COMP_WORDS[at]}
    ((++at))
    if [[ $word == [:=] ]]; then  # bash takes a:b for three words
      ((++at))
    elif [[ $word == -[!0-9]* ]]; then
      [[ " $valued " == *" $word "* ]] || continue
      [[ ${COMP_WORDS[at]} == = ]] && ((at < COMP_CWORD)) && ((++at))
      ((at < COMP_CWORD)) || { owner=$word; break; }
      [[ ${COMP_WORDS[at]} == -[!0-9]* ]] || ((++at))
    elif [[ " $commands " == *" $word "* ]]; then
      place=${place:+$place }$word number=1
      _galilean_place "$place"
    else
      ((++number))
    fi
  done
  [[ $cur == = ]] && cur=''
  ((number > last)) && number=$last
  if [[ $cur == -* ]]; then
    _galilean_words "$options"
  elif [[ $owner ]]; then
    _galilean_value "$place $owner"
  else
    _galilean_words "$commands"
    _galilean_value "$place $number"
    [[ ${COMPREPLY[*]} || $cur ]] || _galilean_words "$options"
  fi
}
complete -F _galilean galilean
)";

std::string in_bash(const std::string& text) {
  return quoted(text, R"('\'')");
}

std::vector<std::string> option_names(const Place& place, bool with_value_only) {
  std::vector<std::string> names;
  for (const auto& option : place.options)
    if (!with_value_only || option.most_values > 0)
      names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// Returns the highest number that an argument counts as. Behind an endless one all count as that.
std::size_t last_argument(const Place& place) {
  constexpr std::size_t kNoLast = 99;
  const bool endless = !place.arguments.empty() && is_endless(place.arguments.back());
  return endless ? place.arguments.size() : kNoLast;
}

/// Returns one branch of _galilean_place.
std::string place_branch(const Place& place) {
  std::vector<std::string> commands;
  for (const auto* command : place.commands) commands.push_back(last_word(command->name));
  return "    " + in_bash(place.path) + ")\n      commands=" + in_bash(joined(commands)) +
         "\n      options=" + in_bash(joined(option_names(place, false))) +
         "\n      valued=" + in_bash(joined(option_names(place, true))) +
         "\n      last=" + std::to_string(last_argument(place)) + " ;;\n";
}

/// Returns the calls that offer values, or an empty text if nothing can be offered.
std::string offers(const OptionDescription& option) {
  std::string calls;
  if (const auto words = words_for(option); !words.empty())
    calls += "_galilean_words " + in_bash(joined(words)) + "; ";
  if (option.files.kind == ValueFiles::Kind::kFile)
    calls += "_galilean_files " + in_bash(option.files.extension) + " ";
  if (option.files.kind == ValueFiles::Kind::kFolder) calls += "_galilean_folders ";
  return calls;
}

/// Returns one branch of _galilean_value. `owner` is an option or the number of an argument.
std::string value_branch(const Place& place, const std::string& owner,
                         const OptionDescription& option) {
  const std::string calls = offers(option);
  if (calls.empty()) return {};
  return "    " + in_bash(place.path + ' ' + owner) + ") " + calls + ";;\n";
}

std::string value_branches(const Place& place) {
  std::string text;
  for (const auto& option : place.options)
    if (option.most_values > 0)
      for (const auto& name : option.names) text += value_branch(place, name, option);
  std::size_t number = 1;
  for (const auto& argument : place.arguments)
    for (int i = 0; i < (is_endless(argument) ? 1 : argument.most_values); ++i)
      text += value_branch(place, std::to_string(number++), argument);
  return text;
}

}  // namespace

std::string bash_completion(const CommandDescription& tree) {
  std::string branches, values;
  for (const auto& place : places_of(tree)) {
    branches += place_branch(place);
    values += value_branches(place);
  }
  return std::string(kBashHead) +
         "\n# Tells what may stand behind the commands $1: `valued` are the options that take a "
         "value.\n_galilean_place() {\n  case $1 in\n" +
         branches +
         "  esac\n}\n\n# Offers what may follow $1: commands, and an option or an argument's "
         "number.\n_galilean_value() {\n  case $1 in\n" +
         values + "  esac\n}\n" + kBashTail;
}

}  // namespace galilean::front
