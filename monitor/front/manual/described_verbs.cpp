// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/described_verbs.h"

#include <algorithm>
#include <future>

#include "monitor/front/manual/program_output.h"
#include "monitor/front/siblings.h"
#include "monitor/front/verbs.h"

namespace galilean::front {
namespace {

Result<CommandDescription> ask(const Verb& verb) {
  std::vector<std::string> command{sibling(verb.program)};
  if (!verb.first_argument.empty()) command.emplace_back(verb.first_argument);
  command.emplace_back(kDescribeCommandLine);
  const auto told = program_output(command);
  if (!told) return told.error();
  auto description = description_from_json(told.value());
  if (!description) return Error{std::string(verb.program) + ": " + description.error().message};
  return description;
}

/// Puts `command` into `outer` under its last word, in place of one of the same name.
void put(CommandDescription command, CommandDescription& outer) {
  const auto same = [&](const CommandDescription& other) { return other.name == command.name; };
  const auto place = std::ranges::find_if(outer.commands, same);
  if (place == outer.commands.end())
    outer.commands.push_back(std::move(command));
  else
    *place = std::move(command);
}

/// Returns the command that `name` belongs into: a verb, or `tree` itself for a name of one word.
CommandDescription& outer_command(const std::string& name, CommandDescription& tree) {
  const auto space = name.find(' ');
  if (space == name.npos) return tree;
  const std::string outer = tree.name + ' ' + name.substr(0, space);
  const auto found = std::ranges::find(tree.commands, outer, &CommandDescription::name);
  return found == tree.commands.end() ? tree : *found;
}

OptionDescription flag(std::vector<std::string> names, const std::string& help) {
  OptionDescription told;
  told.names = std::move(names);
  told.help = help;
  return told;
}

}  // namespace

Result<std::vector<DescribedVerb>> describe_verbs() {
  // Most of the time of a program that describes itself goes into loading its libraries.
  std::vector<std::future<Result<CommandDescription>>> answers;
  for (const auto& verb : verbs())
    answers.push_back(std::async(std::launch::async, [&verb] { return ask(verb); }));
  std::vector<DescribedVerb> described;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    auto answer = answers[i].get();
    if (!answer) return answer.error();
    const Verb& verb = verbs()[i];
    described.push_back(
        {std::string(verb.name), std::string(verb.help), std::move(answer).value()});
  }
  return described;
}

CommandDescription describe_galilean() {
  CommandDescription told;
  told.name = "galilean";
  told.help =
      "Runs, simulates, records, watches and steers a team of robots, whose programs are written "
      "in BHDL, the behaviour and hardware description language. Each verb is a program of its "
      "own.";
  told.requires_command = true;
  told.options = {flag({"-h", "--help"}, "List the verbs"),
                  flag({"--version"}, "Print which release this is")};
  return told;
}

CommandDescription command_tree(const std::vector<DescribedVerb>& verbs) {
  CommandDescription tree = describe_galilean();
  for (const auto& verb : verbs) {
    CommandDescription command = verb.command;
    command.name = tree.name + ' ' + verb.name;
    command.help = verb.help;
    put(std::move(command), outer_command(verb.name, tree));
  }
  for (const auto& own : own_words()) {
    CommandDescription command;
    command.name = tree.name + ' ' + std::string(own.name);
    command.help = own.help;
    tree.commands.push_back(std::move(command));
  }
  return tree;
}

}  // namespace galilean::front
