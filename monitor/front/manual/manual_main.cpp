// SPDX-License-Identifier: BSD-3-Clause
// `galilean manual` and `galilean completion`: manual pages and shells' completion, both made from
// the options that the programs have.
#include <fstream>
#include <iostream>

#include "core/command_line/command_line.h"
#include "monitor/front/manual/completion.h"
#include "monitor/front/manual/manual_page.h"
#include "monitor/front/manual/places.h"
#include "monitor/front/verbs.h"

namespace {

using namespace galilean;
using namespace galilean::front;

struct Options {
  std::string verb;
  std::string second_word;
  std::filesystem::path folder;
  std::string shell;
};

int fail(const std::string& why) {
  std::cerr << "galilean-manual: " << why << '\n';
  return kFailed;
}

int print(const std::string& text) {
  return (std::cout << text).flush() ? 0 : kFailed;
}

int write_pages(const std::vector<DescribedVerb>& verbs, const std::filesystem::path& folder) {
  std::vector<ManualPage> pages{page_of_galilean(verbs)};
  for (const auto& verb : verbs) pages.push_back(page_of(verb, verbs));
  std::error_code ignored;  // the files tell
  std::filesystem::create_directories(folder, ignored);
  for (const auto& page : pages) {
    const auto file = folder / (page.name + ".1");
    if (!(std::ofstream(file) << page.text).flush())
      return fail(file.string() + " cannot be written");
  }
  return 0;
}

/// Requires: there is a verb `name`, or it is empty.
int print_page(const std::vector<DescribedVerb>& verbs, const std::string& name) {
  for (const auto& verb : verbs)
    if (verb.name == name) return print(page_of(verb, verbs).text);
  return print(page_of_galilean(verbs).text);
}

int print_completion(const std::vector<DescribedVerb>& verbs, const std::string& shell) {
  const auto tree = command_tree(verbs);
  return print(shell == "bash"  ? bash_completion(tree)
               : shell == "zsh" ? zsh_completion(tree)
                                : fish_completion(tree));
}

/// Returns the verbs of one word, or the second words of the others.
std::vector<std::string> words_of_verbs(bool second) {
  std::vector<std::string> words;
  for (const auto& verb : verbs())
    if (const std::string name(verb.name); second == (name.find(' ') != name.npos))
      words.push_back(last_word(name));
  return words;
}

void add_manual(CommandLine& app, Options& options) {
  auto manual = app.command("manual", "Prints a manual page, such as `man -l -` shows");
  manual.option("VERB", options.verb, "a verb, such as sim; without it galilean itself")
      .for_example(words_of_verbs(false));
  manual.option("WORD", options.second_word, "the verb's second word, such as ctl in sim ctl")
      .for_example(words_of_verbs(true));
  manual
      .option("--into", options.folder,
              "write the pages of galilean and of all verbs into this folder")
      .names_folder();
}

[[nodiscard]] CommandLine add_completion(CommandLine& app, Options& options) {
  auto completion = app.command("completion",
                                "Prints a script that makes a shell complete galilean's verbs, "
                                "options and values");
  completion.option("SHELL", options.shell, "bash, zsh or fish")
      .required()
      .one_of({"bash", "zsh", "fish"});
  completion.footer(
      "bash reads it from ~/.local/share/bash-completion/completions/galilean, fish from "
      "~/.config/fish/completions/galilean.fish, and zsh from a file _galilean in a folder of "
      "$fpath.");
  return completion;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CommandLine app("Tells how galilean is used.", "galilean");
  app.require_command();
  add_manual(app, options);
  const auto completion = add_completion(app, options);
  if (const auto code = app.parse(argc, argv)) return *code;
  const std::string verb =
      options.verb + (options.second_word.empty() ? "" : " " + options.second_word);
  if (!verb.empty() && !find_verb(verb)) return app.refuse("there is no verb '" + verb + "'");
  const auto verbs = describe_verbs();
  if (!verbs) return fail(verbs.error().message);
  if (completion.chosen()) return print_completion(verbs.value(), options.shell);
  if (!options.folder.empty()) return write_pages(verbs.value(), options.folder);
  return print_page(verbs.value(), verb);
}
