// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/result.h"

namespace CLI {
class Option;
}

namespace galilean {

struct OptionNotes;

/// One option of a command line: what it demands of its text, and what --help says of it. Its
/// functions return it, so that calls can be chained. It belongs to the command line that made it.
class CommandLineOption {
 public:
  /// Requires: `notes` lives as long as `option`.
  CommandLineOption(CLI::Option* option, OptionNotes& notes) : option_(option), notes_(&notes) {}

  CommandLineOption required();
  /// Demands a number from `least` to `most`.
  CommandLineOption between(int least, int most);
  CommandLineOption between(double least, double most);
  /// Demands a number above 0.
  CommandLineOption positive();
  /// Demands a number of at least 0.
  CommandLineOption not_negative();
  /// Demands one of these words.
  CommandLineOption one_of(std::vector<std::string> words);
  /// Demands that `check` accepts the text.
  CommandLineOption check(std::function<Result<void>(const std::string&)> check);
  /// Refuses an empty text, which programs take for an option that was not given.
  CommandLineOption not_empty();
  /// Refuses a command line that gives both options.
  CommandLineOption excludes(CommandLineOption other);
  /// Makes the option take from `least` to `most` texts.
  CommandLineOption takes(int least, int most);
  /// Splits a text into several at this character.
  CommandLineOption divided_by(char character);
  /// Shows what the target holds now as the default.
  CommandLineOption show_default();

  // These change what completion offers and manual pages say. What names a file or a folder is
  // not empty; nothing else is refused.

  /// Says that the text names a file, with this extension if there is one, such as ".bhdl".
  CommandLineOption names_file(const std::string& extension = {});
  /// Says that the text names a file, or by its bare name one that ships in share/galilean/`room`.
  CommandLineOption names_shipped_file(const std::string& room, const std::string& extension);
  CommandLineOption names_folder();
  /// Says that the text may be one of these words, or another.
  CommandLineOption for_example(std::vector<std::string> words);
  /// Says what the default is where it differs from one machine to the next.
  CommandLineOption describe_default(const std::string& words);

  /// Returns whether the option was given.
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
  OptionNotes* notes_;
};

}  // namespace galilean
