// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/claim_parser.h"

#include <algorithm>
#include <array>

#include "bhdl/source/names.h"
#include "monitor/expect/language/quantity_parser.h"

namespace galilean::expect {
namespace {

constexpr std::array<std::string_view, 8> kWords{"always", "never", "eventually", "after",
                                                 "count",  "rate",  "no",         "losses"};
/// The judge keeps so many times of a count in a sliding window.

}  // namespace

std::span<const std::string_view> claim_words() noexcept {
  return kWords;
}

std::optional<Claim> ClaimParser::parse() {
  const std::size_t begin = tokens_.position();
  const Token& first = tokens_.peek();
  auto kind = parse_kind();
  if (!kind) return std::nullopt;
  return Claim{std::move(*kind), tokens_.text_since(begin), tokens_.location(first)};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_kind() {
  if (tokens_.take_word("always")) return parse_always();
  if (tokens_.take_word("never")) return parse_never();
  if (tokens_.take_word("eventually")) return parse_eventually();
  if (tokens_.take_word("after")) return parse_after();
  if (tokens_.take_word("count")) return parse_count();
  if (tokens_.take_word("rate")) return parse_rate();
  if (tokens_.take_word("no")) return parse_no();
  if (tokens_.take_word("losses")) return parse_losses();
  return parse_condition();
}

std::optional<Condition> ClaimParser::condition() {
  return ConditionParser(tokens_, of_robot_).parse();
}

bool ClaimParser::optional_time(std::string_view word, std::optional<double>& time_s) {
  if (!tokens_.take_word(word)) return true;
  time_s = parse_time(tokens_);
  return time_s.has_value();
}

std::optional<ClaimParser::Kind> ClaimParser::parse_always() {
  auto held = condition();
  if (!held) return std::nullopt;
  if (tokens_.at_word("until")) return parse_until(std::move(*held));
  return Always{std::move(*held)};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_never() {
  auto forbidden = condition();
  if (!forbidden) return std::nullopt;
  Never never{std::move(*forbidden), {}};
  if (!optional_time("for", never.for_s)) return std::nullopt;
  return never;
}

std::optional<ClaimParser::Kind> ClaimParser::parse_eventually() {
  Eventually eventually;
  if (!optional_time("within", eventually.within_s)) return std::nullopt;
  auto wanted = condition();
  if (!wanted) return std::nullopt;
  eventually.condition = std::move(*wanted);
  if (!optional_time("for", eventually.for_s)) return std::nullopt;
  return eventually;
}

std::optional<ClaimParser::Kind> ClaimParser::parse_after() {
  auto trigger = condition();
  if (!trigger) return std::nullopt;
  tokens_.take(TokenKind::kComma);
  if (!tokens_.expect_word("within")) return std::nullopt;
  const auto within_s = parse_time(tokens_);
  if (!within_s) return std::nullopt;
  auto response = condition();
  if (!response) return std::nullopt;
  return After{std::move(*trigger), std::move(*response), *within_s};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_until(Condition held) {
  tokens_.next();
  auto end = condition();
  if (!end) return std::nullopt;
  Until until{std::move(held), std::move(*end), {}};
  if (!optional_time("within", until.within_s)) return std::nullopt;
  return until;
}

/// Returns the word that a misspelt beginning of a claim must have meant, or an empty text.
std::string ClaimParser::meant_word() const {
  const Token& first = tokens_.peek();
  if (first.kind != TokenKind::kWord || tokens_.at_word("is", 1)) return {};
  const auto words = condition_words();
  if (std::ranges::find(words, first.text) != words.end()) return {};
  return meant_name(first.text, kWords);
}

std::optional<ClaimParser::Kind> ClaimParser::parse_condition() {
  if (const auto meant = meant_word(); !meant.empty()) {
    tokens_.error(tokens_.peek(), "syntax/unexpected-token",
                  "expected a claim, not " + describe(tokens_.peek()), bhdl::did_you_mean(meant));
    return std::nullopt;
  }
  auto stated = condition();
  if (!stated) return std::nullopt;
  if (tokens_.at_word("until")) return parse_until(std::move(*stated));
  if (!tokens_.take_word("at")) {
    tokens_.expected(
        "'at end' or 'until' behind the condition, or 'always', 'never' or "
        "'eventually' before it",
        {"at", "until"});
    return std::nullopt;
  }
  if (!tokens_.expect_word("end")) return std::nullopt;
  return AtEnd{std::move(*stated)};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_count() {
  if (!tokens_.expect_word("of")) return std::nullopt;
  Count count;
  const Token& word = tokens_.peek();
  if (tokens_.take_word("transitions")) {
    auto transition = ConditionParser(tokens_, of_robot_).parse_transition(word);
    if (!transition) return std::nullopt;
    count.what = std::move(*transition);
  } else if (tokens_.take_word("messages")) {
    if (!tokens_.expect_word("of")) return std::nullopt;
    auto topic = parse_topic(tokens_, of_robot_);
    if (!topic) return std::nullopt;
    topic_ = topic;
    count.what = std::move(*topic);
  } else if (tokens_.take(TokenKind::kLeftParen)) {
    auto counted = condition();
    if (!counted || !tokens_.expect(TokenKind::kRightParen, "')'")) return std::nullopt;
    count.what = std::move(*counted);
  } else {
    tokens_.expected("'transitions', 'messages' or a condition in parentheses",
                     {"transitions", "messages"});
    return std::nullopt;
  }
  if (tokens_.take_word("in")) {
    if (!tokens_.expect_word("any")) return std::nullopt;
    count.window_s = parse_time(tokens_);
    if (!count.window_s) return std::nullopt;
  }
  const Token& sign = tokens_.peek();
  const auto op = parse_operator(tokens_);
  if (!op) return std::nullopt;
  const Token& number = tokens_.peek();
  const auto limit = expect::parse_count(tokens_);
  if (!limit) return std::nullopt;
  if (count.window_s && *op != Operator::kAtMost && *op != Operator::kLess) {
    tokens_.error(sign, "type/wrong-value",
                  "a count in any so much time is compared with < or <= only");
    return std::nullopt;
  }
  if (count.window_s && *limit > static_cast<double>(kMostInWindow)) {
    tokens_.error(number, "type/wrong-value", "a count in any so much time is at most 100000");
    return std::nullopt;
  }
  count.op = *op;
  count.limit = *limit;
  return count;
}

std::optional<ClaimParser::Kind> ClaimParser::parse_rate() {
  if (!tokens_.expect_word("of")) return std::nullopt;
  auto topic = parse_topic(tokens_, of_robot_);
  if (!topic) return std::nullopt;
  topic_ = topic;
  const auto op = parse_operator(tokens_);
  if (!op) return std::nullopt;
  const auto limit = parse_quantity(tokens_, unit::kHertz, "a rate");
  if (!limit) return std::nullopt;
  return Rate{std::move(*topic), *op, limit->si};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_no() {
  const bool gaps = tokens_.take_word("gaps") || tokens_.take_word("gap");
  if (!gaps && !tokens_.take_word("losses")) {
    tokens_.expected("'gaps' or 'losses'", {"gaps", "losses"});
    return std::nullopt;
  }
  auto topic = topic_;
  if (tokens_.take_word(gaps ? "in" : "of")) topic = parse_topic(tokens_, of_robot_);
  if (tokens_.failed()) return std::nullopt;
  if (!topic) {
    tokens_.expected(gaps ? "'in' and a topic" : "'of' and a topic", {"in", "of"});
    return std::nullopt;
  }
  topic_ = topic;
  if (!gaps) return Losses{std::move(*topic), Operator::kEqual, 0};
  if (!tokens_.expect_word("longer") || !tokens_.expect_word("than")) return std::nullopt;
  const auto longest_s = parse_time(tokens_);
  if (!longest_s) return std::nullopt;
  return NoGaps{std::move(*topic), *longest_s};
}

std::optional<ClaimParser::Kind> ClaimParser::parse_losses() {
  if (!tokens_.expect_word("of")) return std::nullopt;
  auto topic = parse_topic(tokens_, of_robot_);
  if (!topic) return std::nullopt;
  topic_ = topic;
  const auto op = parse_operator(tokens_);
  if (!op) return std::nullopt;
  const auto limit = expect::parse_count(tokens_);
  if (!limit) return std::nullopt;
  return Losses{std::move(*topic), *op, *limit};
}

}  // namespace galilean::expect
