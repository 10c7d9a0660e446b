// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "core/command_line/describe.h"
#include "core/command_line/unknown_word.h"
#include "core/standard_output.h"
#include "core/visible_text.h"

namespace galilean {
namespace {

/// Reads the text. Errors: throws the exception that CLI11 reports to the user.
void read_or_throw(const CommandLine::Reader& read, const std::string& names,
                   const std::string& text) {
  if (const auto done = read(text); !done) throw CLI::ValidationError(names, done.error().message);
}

}  // namespace

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : CommandLine(std::make_shared<CLI::App>(description, name),
                  std::make_shared<CommandLineNotes>()) {}

CommandLine::CommandLine(std::shared_ptr<CLI::App> app, std::shared_ptr<CommandLineNotes> notes)
    : app_(std::move(app)), notes_(std::move(notes)) {}
CommandLine::~CommandLine() = default;
CommandLine::CommandLine(CommandLine&&) noexcept = default;

CommandLineOption CommandLine::noted(CLI::Option* option) {
  return {option, notes_->options[option]};
}

CommandLineOption CommandLine::option(const std::string& names, std::string& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, int& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, std::uint64_t& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, double& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, std::optional<double>& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, std::filesystem::path& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help)).names_file();
}

CommandLineOption CommandLine::option(const std::string& names, std::vector<std::string>& target,
                                      const std::string& help) {
  return noted(app_->add_option(names, target, help));
}

CommandLineOption CommandLine::option(const std::string& names, Reader read,
                                      const std::string& help) {
  return noted(app_->add_option_function<std::string>(
      names,
      [read = std::move(read), names](const std::string& text) {
        read_or_throw(read, names, text);
      },
      help));
}

CommandLineOption CommandLine::options(const std::string& names, Reader read,
                                       const std::string& help) {
  return noted(app_->add_option_function<std::vector<std::string>>(
      names,
      [read = std::move(read), names](const std::vector<std::string>& texts) {
        for (const auto& text : texts) read_or_throw(read, names, text);
      },
      help));
}

CommandLineOption CommandLine::flag(const std::string& names, bool& target,
                                    const std::string& help) {
  return noted(app_->add_flag(names, target, help));
}

CommandLineOption CommandLine::flag(const std::string& names, const std::string& help) {
  return noted(app_->add_flag(names)->description(help));
}

CommandLineOption CommandLine::find(const std::string& name) {
  return noted(app_->get_option(name));
}

CommandLine CommandLine::command(const std::string& name, const std::string& help) {
  return {app_->get_subcommand_ptr(app_->add_subcommand(name, help)), notes_};
}

void CommandLine::require_command() {
  app_->require_subcommand(1);
}
void CommandLine::share_options() {
  app_->fallthrough();
}
void CommandLine::footer(const std::string& sentence) {
  app_->footer(sentence);
}
void CommandLine::describe_exit(int code, const std::string& sentence) {
  notes_->exit_codes[app_.get()][std::to_string(code)] = sentence;
}

std::optional<int> CommandLine::parse(int count, const char* const* arguments) {
  tell_unwritten_output();
  if (const auto asked = asked_description(*app_, *notes_, count, arguments)) {
    std::cout << description_to_json(*asked) << std::endl;
    return EXIT_SUCCESS;
  }
  try {
    app_->parse(count, arguments);
    return std::nullopt;
  } catch (const CLI::Success& help) {
    return app_->exit(help);
  } catch (const CLI::RequiredError& error) {
    return refuse(unknown_word(*app_).value_or(error.what()));
  } catch (const CLI::ExtrasError& error) {
    return refuse(unknown_word(*app_).value_or(error.what()));
  } catch (const CLI::ParseError& error) {
    return refuse(error.what());
  }
}

bool CommandLine::chosen() const {
  return app_->parsed();
}

std::string CommandLine::typed() const {
  const CLI::App* command = app_.get();
  std::string name = command->get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += ' ' + command->get_name();
  }
  return name;
}

int CommandLine::refuse(const std::string& sentence) const {
  const std::string name = typed();
  std::cerr << name << ": " << visible(sentence) << "\n'" << name
            << " --help' lists what there is.\n";
  return kWrongUsage;
}

}  // namespace galilean
