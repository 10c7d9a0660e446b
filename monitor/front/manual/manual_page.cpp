// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/manual_page.h"

#include <algorithm>
#include <set>

#include "core/command_line/exit_code.h"
#include "monitor/front/manual/environment.h"
#include "monitor/front/manual/option_text.h"
#include "monitor/front/manual/roff.h"
#include "monitor/front/verbs.h"

namespace galilean::front {
namespace {

constexpr const char* kRelease = "Galilean " GALILEAN_VERSION;

std::string page_name(std::string verb) {
  std::ranges::replace(verb, ' ', '-');
  return "galilean-" + verb;
}

std::string reference(const std::string& page) {
  return Roff::bold(page) + "(1)";
}

void write_name(const std::string& page, const std::string& help, Roff& roff) {
  roff.section("NAME");
  roff.synopsis(Roff::plain(page) + " \\- " + Roff::plain(help));
}

void write_synopsis(const CommandDescription& command, Roff& roff) {
  std::string line = Roff::bold(command.name) + " [" + Roff::italic("OPTION") + "]...";
  for (const auto& option : command.options)
    if (option.names.empty()) line += ' ' + argument_term(option);
  if (command.commands.empty() || !command.requires_command) roff.synopsis(line);
  for (const auto& inner : command.commands) write_synopsis(inner, roff);
}

void write_options(const std::vector<OptionDescription>& options, Roff& roff) {
  for (const auto& option : options) roff.item(option_term(option), option_sentences(option));
}

void write_commands(const std::vector<CommandDescription>& commands, Roff& roff) {
  for (const auto& command : commands) {
    roff.subsection(command.name);
    roff.paragraph(as_sentence(command.help));
    write_options(command.options, roff);
    if (!command.footer.empty()) roff.paragraph(command.footer);
    write_commands(command.commands, roff);
  }
}

/// Adds what exit codes mean in `command` and the commands in it, where that is something else.
void write_own_exit_codes(const CommandDescription& command, const std::string& code, Roff& roff) {
  for (const auto& inner : command.commands) {
    if (const auto own = inner.exit_codes.find(code); own != inner.exit_codes.end())
      roff.item(Roff::bold(code) + ", of " + Roff::plain(inner.name), own->second);
    write_own_exit_codes(inner, code, roff);
  }
}

void write_exit_status(const CommandDescription& command, Roff& roff) {
  roff.section("EXIT STATUS");
  for (const auto& exit : kExitCodes) {
    const std::string code = std::to_string(exit.code);
    const auto own = command.exit_codes.find(code);
    const std::string meaning = own == command.exit_codes.end() ? exit.meaning : own->second;
    if (!meaning.empty()) roff.item(Roff::bold(code), meaning);
    write_own_exit_codes(command, code, roff);
  }
}

template <class Variables>
void write_environment(const Variables& variables, Roff& roff) {
  if (variables.empty()) return;
  roff.section("ENVIRONMENT");
  for (const auto& variable : variables)
    roff.item(Roff::bold(std::string(variable.name)), std::string(variable.meaning));
}

void write_see_also(const std::set<std::string>& pages, Roff& roff) {
  roff.section("SEE ALSO");
  std::string line;
  for (const auto& page : pages) line += (line.empty() ? "" : ", ") + reference(page);
  roff.synopsis(line);
}

/// Returns the page of galilean and those of verbs that begin with the same word.
std::set<std::string> related_pages(const DescribedVerb& verb,
                                    const std::vector<DescribedVerb>& verbs) {
  const auto first_word = [](const std::string& name) { return name.substr(0, name.find(' ')); };
  std::set<std::string> pages{"galilean"};
  for (const auto& other : verbs)
    if (other.name != verb.name && first_word(other.name) == first_word(verb.name))
      pages.insert(page_name(other.name));
  return pages;
}

}  // namespace

ManualPage page_of(const DescribedVerb& verb, const std::vector<DescribedVerb>& verbs) {
  const std::string name = page_name(verb.name);
  const auto& command = verb.command;
  Roff roff(name, kRelease);
  write_name(name, verb.help, roff);
  roff.section("SYNOPSIS");
  write_synopsis(command, roff);
  roff.section("DESCRIPTION");
  roff.paragraph(as_sentence(command.help));
  if (!command.footer.empty()) roff.paragraph(command.footer);
  roff.section("OPTIONS");
  write_options(command.options, roff);
  if (std::ranges::any_of(command.commands, &CommandDescription::takes_outer_options))
    roff.paragraph("These options may stand behind a command, too, but for --help.");
  if (!command.commands.empty()) roff.section("COMMANDS");
  write_commands(command.commands, roff);
  write_exit_status(command, roff);
  write_environment(environment_of(verb), roff);
  write_see_also(related_pages(verb, verbs), roff);
  return {name, roff.text()};
}

ManualPage page_of_galilean(const std::vector<DescribedVerb>& verbs) {
  const CommandDescription galilean = describe_galilean();
  Roff roff(galilean.name, kRelease);
  write_name(galilean.name, "a team of robots that are programmed in BHDL", roff);
  roff.section("SYNOPSIS");
  roff.synopsis(Roff::bold(galilean.name) + " " + Roff::italic("VERB") + " [" +
                Roff::italic("ARGUMENT") + "]...");
  roff.section("DESCRIPTION");
  roff.paragraph(galilean.help);
  roff.section("OPTIONS");
  write_options(galilean.options, roff);
  roff.section("COMMANDS");
  std::set<std::string> pages;
  for (const auto& verb : verbs) {
    roff.item(Roff::bold(verb.name), as_sentence(verb.help));
    pages.insert(page_name(verb.name));
  }
  for (const auto& own : own_words())
    roff.item(Roff::bold(std::string(own.name)), as_sentence(std::string(own.help)));
  write_exit_status(galilean, roff);
  write_environment(environment_variables(), roff);
  write_see_also(pages, roff);
  return {galilean.name, roff.text()};
}

}  // namespace galilean::front
