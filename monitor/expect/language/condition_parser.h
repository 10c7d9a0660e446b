// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/expect/language/expectation.h"
#include "monitor/expect/language/token_reader.h"

namespace galilean::expect {

/// Returns every word that may begin a condition, but for variables, for hints.
[[nodiscard]] std::vector<std::string_view> condition_words();

/// Reads conditions of one expectation. `of_robot` says that it is about a robot and not the team.
class ConditionParser {
 public:
  ConditionParser(TokenReader& tokens, bool of_robot) : tokens_(tokens), of_robot_(of_robot) {}

  /// Returns nothing if it reported an error.
  [[nodiscard]] std::optional<Condition> parse();
  /// Reads `transition from "a" to "b" because "c"` behind that word, each part of which may lack.
  [[nodiscard]] std::optional<Condition> parse_transition(const Token& word);

 private:
  /// Deeper nesting and longer conditions are refused, because reading and judging recurse.
  static constexpr int kDeepest = 64;
  static constexpr std::size_t kMostParts = 1000;

  template <class Many>
  std::optional<Condition> parse_many(std::string_view word,
                                      std::optional<Condition> (ConditionParser::*part)());
  std::optional<Condition> parse_all();
  std::optional<Condition> parse_negated();
  std::optional<Condition> parse_one();
  std::optional<Condition> parse_name(NameIs::What what, const Token& word);
  std::optional<Condition> parse_state(const Token& word);
  std::optional<Condition> parse_robot(const Token& word);
  std::optional<Condition> parse_bit(const Token& word);
  std::optional<Condition> parse_field(const Token& topic);
  std::optional<Condition> parse_validity(const Token& word);
  std::optional<Condition> parse_measure();
  std::optional<Condition> parse_comparison(Comparison comparison, const Unit& unit,
                                            const Token& first);
  std::optional<std::vector<std::string>> parse_texts();
  std::optional<std::string> parse_variable();
  bool needs_robot(const Token& word);
  /// Puts a condition of `kind` into a Not if `negated`.
  [[nodiscard]] Condition made(decltype(Condition::kind) kind, const Token& word,
                               bool negated = false) const;

  TokenReader& tokens_;
  bool of_robot_;
  int depth_ = 0;
  std::size_t parts_ = 0;
};

}  // namespace galilean::expect
