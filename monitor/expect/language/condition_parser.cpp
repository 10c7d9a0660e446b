// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/condition_parser.h"

#include <array>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "monitor/expect/language/measures.h"
#include "monitor/expect/language/quantity_parser.h"

namespace galilean::expect {
namespace {

using MaybeCondition = std::optional<Condition>;

/// Returns every word that may begin a condition, for hints.
std::vector<std::string_view> beginnings() {
  std::vector<std::string_view> words{"state", "program",    "phase", "it",
                                      "bit",   "transition", "not"};
  for (const auto& spec : measure_specs())
    words.push_back(spec.name.substr(0, spec.name.find(' ')));
  return words;
}

}  // namespace

template <class Kind>
Condition ConditionParser::made(Kind kind, const Token& word, bool negated) {
  Condition condition{std::move(kind), tokens_.location(word)};
  if (!negated) return condition;
  Not opposite;
  opposite.part.push_back(std::move(condition));
  return {std::move(opposite), tokens_.location(word)};
}

MaybeCondition ConditionParser::parse() {
  return parse_many<AnyOf>("or", &ConditionParser::parse_all);
}

MaybeCondition ConditionParser::parse_all() {
  return parse_many<AllOf>("and", &ConditionParser::parse_negated);
}

template <class Many>
MaybeCondition ConditionParser::parse_many(std::string_view word,
                                           MaybeCondition (ConditionParser::*part)()) {
  const Token& first = tokens_.peek();
  auto condition = (this->*part)();
  if (!condition || !tokens_.at_word(word)) return condition;
  Many many;
  many.parts.push_back(std::move(*condition));
  while (tokens_.take_word(word)) {
    auto more = (this->*part)();
    if (!more) return std::nullopt;
    many.parts.push_back(std::move(*more));
  }
  return made(std::move(many), first);
}

MaybeCondition ConditionParser::parse_negated() {
  const Token& first = tokens_.peek();
  bool negated = false;
  while (tokens_.take_word("not")) negated = !negated;
  if (++parts_ > kMostParts) {
    tokens_.error(first, "syntax/too-long",
                  "a claim has at most " + std::to_string(kMostParts) + " conditions",
                  "divide it into several");
    return std::nullopt;
  }
  auto condition = parse_one();
  if (!condition || !negated) return condition;
  return made(std::move(condition->kind), first, true);
}

MaybeCondition ConditionParser::parse_one() {
  const Token& word = tokens_.peek();
  if (tokens_.take(TokenKind::kLeftParen)) {
    if (++depth_ > kDeepest) {
      tokens_.error(word, "syntax/too-deep",
                    "parentheses stand at most " + std::to_string(kDeepest) + " deep");
      return std::nullopt;
    }
    auto inner = parse();
    --depth_;
    if (!inner || !tokens_.expect(TokenKind::kRightParen, "')'")) return std::nullopt;
    return inner;
  }
  if (tokens_.take(TokenKind::kTopic)) return parse_field(word);
  if (tokens_.take_word("state")) return parse_state(word);
  if (tokens_.take_word("program")) return parse_name(NameIs::What::kProgram, word);
  if (tokens_.take_word("phase")) return parse_name(NameIs::What::kPhase, word);
  if (tokens_.take_word("it")) return parse_robot(word);
  if (tokens_.take_word("bit")) return parse_bit(word);
  if (tokens_.take_word("transition")) return parse_transition(word);
  const bool name = word.kind == TokenKind::kWord || word.kind == TokenKind::kText;
  if (name && tokens_.at_word("is", 1)) return tokens_.next(), parse_validity(word);
  return parse_measure();
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

MaybeCondition ConditionParser::parse_name(NameIs::What what, const Token& word) {
  if (what == NameIs::What::kProgram && !needs_robot(word)) return std::nullopt;
  if (!tokens_.expect_word("is")) return std::nullopt;
  const bool negated = tokens_.take_word("not");
  auto texts = parse_texts();
  if (!texts) return std::nullopt;
  return made(NameIs{what, {}, {}, std::move(*texts)}, word, negated);
}

MaybeCondition ConditionParser::parse_state(const Token& word) {
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

MaybeCondition ConditionParser::parse_transition(const Token& word) {
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

MaybeCondition ConditionParser::parse_robot(const Token& word) {
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

MaybeCondition ConditionParser::parse_bit(const Token& word) {
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

MaybeCondition ConditionParser::parse_validity(const Token& word) {
  if (!needs_robot(word) || !tokens_.expect_word("is")) return std::nullopt;
  const bool negated = tokens_.take_word("not");
  if (!tokens_.take_word("valid")) {
    tokens_.expected("'valid'", {"valid"});
    return std::nullopt;
  }
  return made(VariableIsValid{std::string(word.text)}, word, negated);
}

MaybeCondition ConditionParser::parse_field(const Token& topic) {
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

MaybeCondition ConditionParser::parse_measure() {
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
                                 : bhdl::did_you_mean(meant_name(first.text, beginnings())));
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

MaybeCondition ConditionParser::parse_comparison(Comparison comparison, const Unit& unit,
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
