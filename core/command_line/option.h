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

/// One option of a command line: what it demands of its text, and what --help says of it. Its
/// functions return it, so that calls can be chained. It belongs to the command line that made it.
class CommandLineOption {
 public:
  explicit CommandLineOption(CLI::Option* option) : option_(option) {}

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
  /// Refuses a command line that gives both options.
  CommandLineOption excludes(CommandLineOption other);
  /// Makes the option take from `least` to `most` texts.
  CommandLineOption takes(int least, int most);
  /// Splits a text into several at this character.
  CommandLineOption divided_by(char character);
  /// Shows what the target holds now as the default.
  CommandLineOption show_default();
  /// Returns whether the option was given.
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
};

}  // namespace galilean
