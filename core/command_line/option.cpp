// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/option.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace galilean {

CommandLineOption CommandLineOption::required() {
  return option_->required(), *this;
}

CommandLineOption CommandLineOption::between(int least, int most) {
  return option_->check(CLI::Range(least, most)), *this;
}

CommandLineOption CommandLineOption::between(double least, double most) {
  return option_->check(CLI::Range(least, most)), *this;
}

CommandLineOption CommandLineOption::positive() {
  return option_->check(CLI::PositiveNumber), *this;
}

CommandLineOption CommandLineOption::not_negative() {
  return option_->check(CLI::NonNegativeNumber), *this;
}

CommandLineOption CommandLineOption::one_of(std::vector<std::string> words) {
  return option_->check(CLI::IsMember(std::move(words))), *this;
}

CommandLineOption CommandLineOption::check(std::function<Result<void>(const std::string&)> check) {
  option_->check([check = std::move(check)](const std::string& text) {
    const auto checked = check(text);
    return checked ? std::string() : checked.error().message;
  });
  return *this;
}

CommandLineOption CommandLineOption::excludes(CommandLineOption other) {
  return option_->excludes(other.option_), *this;
}

CommandLineOption CommandLineOption::takes(int least, int most) {
  return option_->expected(least, most), *this;
}

CommandLineOption CommandLineOption::divided_by(char character) {
  return option_->delimiter(character), *this;
}

CommandLineOption CommandLineOption::show_default() {
  return option_->capture_default_str(), *this;
}

bool CommandLineOption::given() const {
  return option_->count() > 0;
}

}  // namespace galilean
