// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "monitor/expect/language/condition_parser.h"
#include "monitor/expect/language/measures.h"
#include "monitor/expect/language/quantity_parser.h"

// What a condition is made of: the parts without "and", "or" and parentheses.

namespace galilean::expect {

Condition ConditionParser::made(decltype(Condition::kind) kind, const Token& word,
                                bool negated) const {
  Condition condition{std::move(kind), tokens_.location(word)};
  if (!negated) return condition;
  Not opposite;
  opposite.part.push_back(std::move(condition));
  return {std::move(opposite), tokens_.location(word)};
}

bool ConditionParser::needs_robot(const Token& word) {
  return of_robot_ ||
         tokens_.error(word, "name/no-robot",
                       bhdl::in_quotes(word.text) + " is of a robot, and the team has none",
                       "begin with 'every robot:', 'some robot:' or a robot's name");
}

std::optional<std::vector<std::string>> ConditionParser::parse_texts() {
  std::vector<std::string> texts;
  do {
    const Token& text = tokens_.peek();
    if (!tokens_.expect(TokenKind::kText, "a name in quotes, such as \"wander\""))
      return std::nullopt;
    texts.emplace_back(text.text);
  } while (tokens_.at_word("or") && tokens_.peek(1).kind == TokenKind::kText &&
           tokens_.take_word("or"));
  return texts;
}

std::optional<Condition> ConditionParser::parse_name(NameIs::What what, const Token& word) {
  if (what == NameIs::What::kProgram && !needs_robot(word)) return std::nullopt;
  if (!tokens_.expect_word("is")) return std::nullopt;
  const bool negated = tokens_.take_word("not");
  auto texts = parse_texts();
  if (!texts) return std::nullopt;
  return made(NameIs{what, {}, {}, std::move(*texts)}, word, negated);
}

std::optional<Condition> ConditionParser::parse_state(const Token& word) {
  if (!needs_robot(word)) return std::nullopt;
  if (tokens_.at_word("is")) return parse_name(NameIs::What::kState, word);
  if (!tokens_.take_word("becomes")) {
    tokens_.expected("'is' or 'becomes'", {"is", "becomes"});
    return std::nullopt;
  }
  auto texts = parse_texts();
  if (!texts) return std::nullopt;
  if (texts->size() == 1) return made(Transition{{}, texts->front(), {}}, word);
  AnyOf any;
  for (auto& text : *texts) any.parts.push_back(made(Transition{{}, std::move(text), {}}, word));
  return made(std::move(any), word);
}

std::optional<Condition> ConditionParser::parse_transition(const Token& word) {
  if (!needs_robot(word)) return std::nullopt;
  Transition transition;
  const auto part = [&](std::string_view keyword, std::string& to) {
    if (!tokens_.take_word(keyword)) return true;
    const Token& text = tokens_.peek();
    if (!tokens_.expect(TokenKind::kText, "a text in quotes")) return false;
    to = text.text;
    return true;
  };
  if (!part("from", transition.from) || !part("to", transition.to) ||
      !part("because", transition.cause))
    return std::nullopt;
  return made(std::move(transition), word);
}

std::optional<Condition> ConditionParser::parse_robot(const Token& word) {
  if (!needs_robot(word) || !tokens_.expect_word("is")) return std::nullopt;
  const bool negated = tokens_.take_word("not");
  using What = RobotIs::What;
  if (tokens_.take_word("healthy")) return made(RobotIs{What::kHealthy}, word, negated);
  if (tokens_.take_word("held")) return made(RobotIs{What::kHeld}, word, negated);
  if (tokens_.take_word("in")) {
    if (!tokens_.expect_word("probation")) return std::nullopt;
    return made(RobotIs{What::kInProbation}, word, negated);
  }
  if (tokens_.take_word("out")) {
    if (!tokens_.expect_word("of") || !tokens_.expect_word("service")) return std::nullopt;
    return made(RobotIs{What::kOutOfService}, word, negated);
  }
  tokens_.expected("'healthy', 'held', 'in probation' or 'out of service'",
                   {"healthy", "held", "in", "out"});
  return std::nullopt;
}

std::optional<std::string> ConditionParser::parse_variable() {
  const Token& name = tokens_.peek();
  if (tokens_.take(TokenKind::kWord) || tokens_.take(TokenKind::kText))
    return std::string(name.text);
  tokens_.expected("a variable's name");
  return std::nullopt;
}

std::optional<Condition> ConditionParser::parse_bit(const Token& word) {
  constexpr double kMostBits = 64;
  if (!needs_robot(word)) return std::nullopt;
  const Token& number = tokens_.peek();
  if (!tokens_.expect(TokenKind::kNumber, "the number of a bit")) return std::nullopt;
  if (!(number.number >= 0 && number.number < kMostBits) ||
      number.number != static_cast<int>(number.number)) {
    tokens_.error(number, "type/wrong-value", "a bit is a whole number from 0 to 63");
    return std::nullopt;
  }
  if (!tokens_.expect_word("of")) return std::nullopt;
  auto variable = parse_variable();
  if (!variable || !tokens_.expect_word("is")) return std::nullopt;
  const Token& value = tokens_.peek();
  if (!tokens_.at(TokenKind::kNumber) || (value.number != 0 && value.number != 1)) {
    tokens_.expected("0 or 1");
    return std::nullopt;
  }
  tokens_.next();
  return made(BitIs{std::move(*variable), static_cast<int>(number.number), value.number == 1},
              word);
}

std::optional<Condition> ConditionParser::parse_validity(const Token& word) {
  if (!needs_robot(word) || !tokens_.expect_word("is")) return std::nullopt;
  const bool negated = tokens_.take_word("not");
  if (tokens_.at(TokenKind::kText)) {
    tokens_.error(word, "name/unknown-measure",
                  bhdl::in_quotes(word.text) +
                      " is not compared with a name; state, program, "
                      "phase and fields are",
                  bhdl::did_you_mean(meant_name(word.text, condition_words())));
    return std::nullopt;
  }
  if (!tokens_.take_word("valid")) {
    tokens_.expected("'valid'", {"valid"});
    return std::nullopt;
  }
  return made(VariableIsValid{std::string(word.text)}, word, negated);
}

std::optional<Condition> ConditionParser::parse_field(const Token& topic) {
  const auto dot = topic.text.find('.');
  if (dot == std::string_view::npos) {
    tokens_.error(topic, "syntax/unexpected-token",
                  "expected a field of the topic " + bhdl::in_quotes(topic.text),
                  "write TOPIC.FIELD, such as /io/odom.twist.twist.linear.x");
    return std::nullopt;
  }
  if (topic.text.starts_with('~') && !needs_robot(topic)) return std::nullopt;
  TopicName name{std::string(topic.text.substr(0, dot))};
  std::string field(topic.text.substr(dot + 1));
  if (tokens_.take_word("is")) {
    const bool negated = tokens_.take_word("not");
    auto texts = parse_texts();
    if (!texts) return std::nullopt;
    return made(NameIs{NameIs::What::kField, std::move(name), std::move(field), std::move(*texts)},
                topic, negated);
  }
  Comparison comparison;
  comparison.topic = std::move(name);
  comparison.field = std::move(field);
  const Unit unit = unit_of_field(comparison.field);
  return parse_comparison(std::move(comparison), unit, topic);
}

std::optional<Condition> ConditionParser::parse_measure() {
  const Token& first = tokens_.peek();
  if (first.kind != TokenKind::kWord) {
    tokens_.expected("a condition, such as state is \"wander\"");
    return std::nullopt;
  }
  const std::string both = std::string(first.text) + ' ' + std::string(tokens_.peek(1).text);
  const bool two_words = find_measure(both, true) || find_measure(both, false);
  const std::string name = two_words ? both : std::string(first.text);
  const bool of_variable = tokens_.at_word("of", two_words ? 2 : 1);
  const auto* spec = find_measure(name, of_variable);
  if (!spec) {
    const auto* other = find_measure(name, !of_variable);
    const bool lacks_variable = other && !of_variable;
    tokens_.error(first, "name/unknown-measure",
                  lacks_variable ? bhdl::in_quotes(name) + " is of a variable"
                  : other        ? bhdl::in_quotes(name) + " is of no variable"
                          : "there is nothing to measure that is called " + bhdl::in_quotes(name),
                  lacks_variable ? bhdl::Hint("write '" + name + " of' and the variable's name")
                                 : bhdl::did_you_mean(meant_name(first.text, condition_words())));
    return std::nullopt;
  }
  if (spec->of != MeasureSpec::Of::kScore && !needs_robot(first)) return std::nullopt;
  tokens_.next();
  if (two_words) tokens_.next();
  Comparison comparison;
  comparison.measure = spec->measure;
  if (of_variable) {
    tokens_.next();
    auto variable = parse_variable();
    if (!variable) return std::nullopt;
    comparison.variable = std::move(*variable);
  }
  return parse_comparison(std::move(comparison), spec->unit, first);
}

std::optional<Condition> ConditionParser::parse_comparison(Comparison comparison, const Unit& unit,
                                                           const Token& first) {
  const auto op = parse_operator(tokens_);
  if (!op) return std::nullopt;
  const std::string of =
      comparison.field.empty() ? std::string(spec_of(comparison.measure).name) : comparison.field;
  const auto limit = parse_quantity(tokens_, unit, of);
  if (!limit) return std::nullopt;
  comparison.op = *op;
  comparison.limit = limit->si;
  comparison.unit = limit->unit;
  return made(std::move(comparison), first);
}

}  // namespace galilean::expect
