// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/option_text.h"

#include "monitor/front/manual/places.h"
#include "monitor/front/manual/roff.h"

namespace galilean::front {
namespace {

/// Returns "a, b and c" with the word between the last two.
std::string listing(const std::vector<std::string>& words, const std::string& between_last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " " + between_last + " " : ", ";
    text += words[i];
  }
  return text;
}

std::string value_term(const OptionDescription& option) {
  std::string term = Roff::italic(option.value);
  if (is_endless(option)) term += "...";
  return option.least_values == 0 ? " [" + term + "]" : " " + term;
}

}  // namespace

std::string option_term(const OptionDescription& option) {
  if (option.names.empty()) return argument_term(option);
  std::string term;
  for (const auto& name : option.names) term += (term.empty() ? "" : ", ") + Roff::bold(name);
  return option.most_values == 0 ? term : term + value_term(option);
}

std::string argument_term(const OptionDescription& argument) {
  std::string term = Roff::italic(argument.argument);
  if (is_endless(argument))
    term += "...";
  else
    for (int i = 1; i < argument.most_values; ++i) {
      const std::string more = Roff::italic(argument.argument);
      term += i < argument.least_values ? " " + more : " [" + more + "]";
    }
  return argument.required ? term : "[" + term + "]";
}

std::string option_sentences(const OptionDescription& option) {
  std::string text = as_sentence(option.help);
  if (!option.range.empty()) text += " The value must be " + option.range + ".";
  if (!option.choices.empty()) text += " The value must be " + listing(option.choices, "or") + ".";
  if (!option.default_value.empty()) text += " Default: " + option.default_value + ".";
  if (option.required && !option.names.empty()) text += " It must be given.";
  return text;
}

std::string as_sentence(const std::string& text) {
  const bool ends = !text.empty() && std::string_view(".!?").find(text.back()) != std::string::npos;
  return text.empty() || ends ? text : text + ".";
}

}  // namespace galilean::front
