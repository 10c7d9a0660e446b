// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/option.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <utility>

#include "core/command_line/option_notes.h"
#include "core/visible_text.h"

namespace galilean {
namespace {

template <class Number>
std::string range_in_words(Number least, Number most) {
  std::ostringstream text;
  text << "from " << least << " to " << most;
  return text.str();
}

/// Returns the check that a text is a finite number for which `holds`, which is `range` in words.
/// Help shows those behind the option's type.
CLI::Validator number_check(const std::string& range, std::function<bool(double)> holds) {
  const auto check = [range, holds = std::move(holds)](const std::string& text) -> std::string {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == 0 && std::isfinite(number) && holds(number)) return "";
    return "the value must be " + range + ", and not '" + visible(text) + "'";
  };
  return {check, range};
}

}  // namespace

CommandLineOption CommandLineOption::required() {
  return option_->required(), *this;
}

CommandLineOption CommandLineOption::between(int least, int most) {
  notes_->range = range_in_words(least, most);
  return option_->check(number_check(
             notes_->range, [=](double number) { return number >= least && number <= most; })),
         *this;
}

CommandLineOption CommandLineOption::between(double least, double most) {
  notes_->range = range_in_words(least, most);
  return option_->check(number_check(
             notes_->range, [=](double number) { return number >= least && number <= most; })),
         *this;
}

CommandLineOption CommandLineOption::positive() {
  notes_->range = "above 0";
  return option_->check(number_check(notes_->range, [](double number) { return number > 0; })),
         *this;
}

CommandLineOption CommandLineOption::not_negative() {
  notes_->range = "at least 0";
  return option_->check(number_check(notes_->range, [](double number) { return number >= 0; })),
         *this;
}

CommandLineOption CommandLineOption::one_of(std::vector<std::string> words) {
  notes_->choices = words;
  return option_->check(CLI::IsMember(std::move(words))), *this;
}

CommandLineOption CommandLineOption::check(std::function<Result<void>(const std::string&)> check) {
  option_->check([check = std::move(check)](const std::string& text) {
    const auto checked = check(text);
    return checked ? std::string() : checked.error().message;
  });
  return *this;
}

CommandLineOption CommandLineOption::not_empty() {
  return check([](const std::string& text) -> Result<void> {
    if (!text.empty()) return {};
    return Error{"the value is empty; give one, or leave the option out"};
  });
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

CommandLineOption CommandLineOption::names_file(const std::string& extension) {
  notes_->files = {.kind = ValueFiles::Kind::kFile, .extension = extension, .shipped = {}};
  return not_empty();
}

CommandLineOption CommandLineOption::names_shipped_file(const std::string& room,
                                                        const std::string& extension) {
  notes_->files = {.kind = ValueFiles::Kind::kFile, .extension = extension, .shipped = room};
  return not_empty();
}

CommandLineOption CommandLineOption::names_folder() {
  notes_->files = {.kind = ValueFiles::Kind::kFolder, .extension = {}, .shipped = {}};
  return not_empty();
}

CommandLineOption CommandLineOption::for_example(std::vector<std::string> words) {
  notes_->examples = std::move(words);
  return *this;
}

CommandLineOption CommandLineOption::describe_default(const std::string& words) {
  notes_->default_value = words;
  return *this;
}

bool CommandLineOption::given() const {
  return option_->count() > 0;
}

}  // namespace galilean
