// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/quantity_parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "core/plural.h"
#include "monitor/expect/language/measures.h"

namespace galilean::expect {
namespace {

/// A longer time could not be counted in nanoseconds with a recording's.
constexpr double kLongestTime_s = 1e9, kLargestCount = 1e12;

/// The words that may follow a quantity. Any other word is taken for its unit.
constexpr std::array<std::string_view, 9> kFollowing{"and",    "or",     "at",    "for", "until",
                                                     "within", "always", "never", "not"};

bhdl::Hint unit_hint(std::string_view word) {
  if (const auto meant = meant_unit(word); !meant.empty()) return bhdl::did_you_mean(meant);
  std::vector<std::string_view> symbols;
  for (const auto& unit : all_units())
    if (!unit.symbol.empty()) symbols.push_back(unit.symbol);
  return bhdl::did_you_mean(meant_name(word, symbols));
}

std::string examples_of(const Unit& wanted) {
  std::string text;
  for (const auto& unit : all_units())
    if (unit.dimension == wanted.dimension && !unit.symbol.empty())
      text += (text.empty() ? "" : ", ") + std::string(unit.symbol);
  return text;
}

std::string unit_words(const Unit& wanted) {
  const auto examples = examples_of(wanted);
  return agreeing(1 + std::ranges::count(examples, ','), "its unit is ", "its units are ") +
         examples;
}

std::string dimension_of(const Unit& unit) {
  return std::string(unit.dimension) == "number" ? "a number without a unit"
                                                 : std::string(unit.dimension);
}

}  // namespace

std::optional<Quantity> parse_quantity(TokenReader& tokens, const Unit& wanted,
                                       std::string_view of) {
  if (!tokens.at(TokenKind::kNumber)) {
    tokens.expected(
        std::string(of) + ", such as " +
        (wanted.dimension == unit::kNone.dimension ? "3" : "3 " + std::string(wanted.symbol)));
    return std::nullopt;
  }
  const Token& number = tokens.next();
  const Token& word = tokens.peek();
  const bool has_unit =
      word.kind == TokenKind::kWord && std::ranges::find(kFollowing, word.text) == kFollowing.end();
  if (!has_unit) {
    if (wanted.dimension == unit::kNone.dimension || number.number == 0)
      return Quantity{number.number, wanted};
    tokens.error(number, "type/missing-unit",
                 bhdl::in_quotes(number.text) + " has no unit: " + std::string(of) + " is in " +
                     examples_of(wanted),
                 bhdl::did_you_mean(std::string(number.text) + " " + std::string(wanted.symbol)));
    return std::nullopt;
  }
  const auto unit = find_expectation_unit(word.text);
  if (!unit) {
    tokens.error(word, "syntax/unknown-unit", "there is no unit " + bhdl::in_quotes(word.text),
                 unit_hint(word.text));
    return std::nullopt;
  }
  if (unit->dimension != wanted.dimension) {
    tokens.error(word, "type/wrong-unit",
                 bhdl::in_quotes(word.text) + " is a unit of " + dimension_of(*unit) + "; " +
                     std::string(of) + " is " + dimension_of(wanted),
                 wanted.symbol.empty() ? "" : unit_words(wanted));
    return std::nullopt;
  }
  tokens.next();
  return Quantity{number.number * unit->to_si, *unit};
}

std::optional<double> parse_time(TokenReader& tokens) {
  const Token& number = tokens.peek();
  const auto time = parse_quantity(tokens, unit::kSecond, "a time");
  if (!time) return std::nullopt;
  if (time->si > 0 && time->si <= kLongestTime_s) return time->si;
  tokens.error(number, "type/wrong-value", "a time is above 0 and at most 30 years");
  return std::nullopt;
}

std::optional<Operator> parse_operator(TokenReader& tokens) {
  using Sign = std::pair<std::string_view, Operator>;
  constexpr std::array kOperators{Sign{"=", Operator::kEqual},    Sign{"==", Operator::kEqual},
                                  Sign{"!=", Operator::kUnequal}, Sign{"<", Operator::kLess},
                                  Sign{"<=", Operator::kAtMost},  Sign{">", Operator::kGreater},
                                  Sign{">=", Operator::kAtLeast}};
  const auto found = std::ranges::find(kOperators, tokens.peek().text, &Sign::first);
  if (tokens.at(TokenKind::kOperator) && found != kOperators.end())
    return tokens.next(), found->second;
  tokens.expected("one of = != < <= > >=");
  return std::nullopt;
}

std::optional<double> parse_count(TokenReader& tokens) {
  const Token& number = tokens.peek();
  const auto count = parse_quantity(tokens, unit::kNone, "a count");
  if (!count) return std::nullopt;
  if (count->si >= 0 && count->si <= kLargestCount && count->si == std::floor(count->si))
    return count->si;
  tokens.error(number, "type/wrong-value", "a count is a whole number from 0");
  return std::nullopt;
}

std::optional<TopicName> parse_topic(TokenReader& tokens, bool of_robot) {
  const Token& topic = tokens.peek();
  if (!tokens.expect(TokenKind::kTopic, "a topic, such as /io/state")) return std::nullopt;
  if (topic.text.find('.') != std::string_view::npos || topic.text.ends_with('/')) {
    tokens.error(topic, "syntax/unexpected-token",
                 "expected a topic without a field, not " + bhdl::in_quotes(topic.text),
                 bhdl::did_you_mean(topic.text.substr(0, topic.text.find('.'))));
    return std::nullopt;
  }
  if (topic.text.starts_with('~') && !of_robot) {
    tokens.error(topic, "name/no-robot",
                 bhdl::in_quotes(topic.text) + " is a topic of a robot, and the team is none",
                 "name the topic from its /, or begin with 'every robot:'");
    return std::nullopt;
  }
  return TopicName{std::string(topic.text)};
}

}  // namespace galilean::expect
