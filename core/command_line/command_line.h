// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/command_line/exit_code.h"
#include "core/command_line/option.h"

namespace CLI {
class App;
}

namespace galilean {

struct CommandLineNotes;

/// The options and commands of a program, and what its --help says. CLI11 reads them; its headers
/// are included by this class's sources alone, because a file that includes them takes seconds to
/// compile.
///
/// Names are as CLI11 writes them: "-v,--verbose" for an option, "file" for an argument by
/// position. parse() writes the targets, which must live until then. What a target holds before is
/// its default.
class CommandLine {
 public:
  /// Reads an option's text. Errors: the text is not accepted; the error says why in one sentence.
  using Reader = std::function<Result<void>(const std::string&)>;

  /// `name` is what users type, such as "galilean record". It stands in --help and in messages.
  CommandLine(const std::string& description, const std::string& name);
  ~CommandLine();
  CommandLine(CommandLine&&) noexcept;
  CommandLine& operator=(CommandLine&&) = delete;

  CommandLineOption option(const std::string& names, std::string& target, const std::string& help);
  CommandLineOption option(const std::string& names, int& target, const std::string& help);
  CommandLineOption option(const std::string& names, std::uint64_t& target,
                           const std::string& help);
  CommandLineOption option(const std::string& names, double& target, const std::string& help);
  CommandLineOption option(const std::string& names, std::optional<double>& target,
                           const std::string& help);
  CommandLineOption option(const std::string& names, std::filesystem::path& target,
                           const std::string& help);
  /// Adds an option that may be given more than once, and that takes more than one value each time.
  CommandLineOption option(const std::string& names, std::vector<std::string>& target,
                           const std::string& help);
  /// Adds an option whose text `read` is called with. Requires: what `read` refers to lives until
  /// parse() returns.
  CommandLineOption option(const std::string& names, Reader read, const std::string& help);
  /// Adds an option that takes several texts. `read` is called with each of them.
  CommandLineOption options(const std::string& names, Reader read, const std::string& help);
  CommandLineOption flag(const std::string& names, bool& target, const std::string& help);
  /// Adds a flag that is accepted and changes nothing.
  CommandLineOption flag(const std::string& names, const std::string& help);
  /// Returns the option of that name, such as "--try". Requires: it was added.
  CommandLineOption find(const std::string& name);

  /// Adds a command, such as `list` in `programs list`, with a command line of its own.
  CommandLine command(const std::string& name, const std::string& help);
  /// Demands that one of the commands is given.
  void require_command();
  /// Lets this command line's options stand behind a command, too.
  void share_options();
  /// Adds a sentence below --help.
  void footer(const std::string& sentence);
  /// Says in the manual page what this exit code means here, if not what exit_code.h says.
  void describe_exit(int code, const std::string& sentence);

  /// Reads the arguments, of which the first is the program. Returns nothing if the program is to
  /// go on, and the exit code otherwise. The exit code is 0 if --help was asked for and printed. It
  /// is kWrongUsage if the arguments are wrong and the reason was printed. For an unknown word the
  /// reason says what may have been meant.
  /// If the last argument is kDescribeCommandLine (description.h) and no option is before it, this
  /// prints what is described there, and returns 0.
  /// Calls tell_unwritten_output(), so that every program says if what it prints is lost.
  [[nodiscard]] std::optional<int> parse(int count, const char* const* arguments);
  /// Returns whether this command was given.
  [[nodiscard]] bool chosen() const;
  /// Returns what the user typed without options, such as "galilean hold". Requires: parse() was
  /// called.
  [[nodiscard]] std::string typed() const;
  /// Prints why the arguments are wrong, as parse() does. Returns kWrongUsage.
  [[nodiscard]] int refuse(const std::string& sentence) const;

 private:
  CommandLine(std::shared_ptr<CLI::App> app, std::shared_ptr<CommandLineNotes> notes);
  /// Returns the option together with its notes.
  [[nodiscard]] CommandLineOption noted(CLI::Option* option);

  std::shared_ptr<CLI::App> app_;
  std::shared_ptr<CommandLineNotes> notes_;  ///< one for a command line and all its commands
};

}  // namespace galilean
