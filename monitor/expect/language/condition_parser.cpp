// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/condition_parser.h"

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "monitor/expect/language/measures.h"
#include "monitor/expect/language/quantity_parser.h"

namespace galilean::expect {
namespace {

using MaybeCondition = std::optional<Condition>;

}  // namespace

std::vector<std::string_view> condition_words() {
  std::vector<std::string_view> words{"state", "program",    "phase", "it",
                                      "bit",   "transition", "not"};
  for (const auto& spec : measure_specs())
    words.push_back(spec.name.substr(0, spec.name.find(' ')));
  return words;
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

}  // namespace galilean::expect
