// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/parser.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "bhdl/source/readable.h"
#include "bhdl/source/text.h"
#include "monitor/expect/language/claim_parser.h"

namespace galilean::expect {
namespace {

std::optional<Scope> parse_scope(TokenReader& tokens) {
  const bool every = tokens.at_word("every"), some = tokens.at_word("some");
  if (every || some) {
    tokens.next();
    if (!tokens.expect_word("robot")) return std::nullopt;
    return Scope{every ? Scope::Who::kEvery : Scope::Who::kSome, {}};
  }
  if (tokens.at_word("team")) return tokens.next(), Scope{};
  const Token& name = tokens.peek();
  if (tokens.at(TokenKind::kText) || tokens.at(TokenKind::kWord)) {
    if (name.text.empty()) {
      tokens.error(name, "name/empty", "a robot's name is empty");
      return std::nullopt;
    }
    return tokens.next(), Scope{Scope::Who::kNamed, std::string(name.text)};
  }
  tokens.expected("'every robot', 'some robot', 'team' or a robot's name");
  return std::nullopt;
}

/// Takes the colon behind a scope. A claim without a scope is the usual mistake.
bool take_colon(TokenReader& tokens, const Token& first) {
  if (tokens.take(TokenKind::kColon)) return true;
  const auto words = claim_words();
  const bool claim = std::ranges::find(words, first.text) != words.end();
  constexpr std::string_view kWho = "say whom it is about first: 'every robot:', 'team:' or 'io:'";
  if (claim)
    return tokens.error(first, "syntax/missing-scope", "the claim is about nobody",
                        {std::string(kWho)});
  const std::vector<std::string_view> scopes{"every", "some", "team"};
  auto hint = first.kind == TokenKind::kWord ? bhdl::did_you_mean(meant_name(first.text, scopes))
                                             : bhdl::Hint();
  if (hint.text.empty()) hint = std::string(kWho);
  return tokens.error(tokens.peek(), "syntax/missing-colon",
                      "expected ':' behind " + describe(first) + ", not " + describe(tokens.peek()),
                      std::move(hint));
}

class ExpectationParser {
 public:
  ExpectationParser(const std::string& file, const std::vector<Token>& list,
                    bhdl::Diagnostics& diagnostics)
      : tokens_(file, list, diagnostics) {}

  std::optional<Expectation> parse() {
    const Token& first = tokens_.peek();
    const auto scope = parse_scope(tokens_);
    if (!scope || !take_colon(tokens_, first)) return std::nullopt;
    Expectation expectation{*scope, {}, {}, tokens_.location(first)};
    ClaimParser claims(tokens_, scope->who != Scope::Who::kTeam);
    do {
      recovered_ = false;
      auto claim = claims.parse();
      if (claim && !tokens_.at(TokenKind::kComma) && !tokens_.at(TokenKind::kEnd)) {
        tokens_.expected("',' or the end of the expectation",
                         {"and", "or", "until", "within", "for", "at"});
        claim.reset();
      }
      if (claim)
        expectation.claims.push_back(std::move(*claim));
      else
        skip_claim();
    } while (!tokens_.at(TokenKind::kEnd) && (recovered_ || tokens_.take(TokenKind::kComma)));
    if (whole_) expectation.text = tokens_.text_since(0);
    return whole_ ? std::optional(std::move(expectation)) : std::nullopt;
  }

 private:
  void skip_claim() {
    whole_ = false;
    tokens_.recover(claim_words());
    recovered_ = true;
  }

  TokenReader tokens_;
  bool whole_ = true, recovered_ = false;
};

}  // namespace

Parsed parse(const std::string& file, std::string_view text) {
  bhdl::Diagnostics diagnostics;
  Parsed parsed;
  if (text.size() > kMostBytes)
    diagnostics.error({file, 1, 1}, "file/too-large",
                      "the file has " + std::to_string(text.size()) +
                          " bytes; expectations have at most " + std::to_string(kMostBytes));
  else if (bhdl::is_readable(file, text, diagnostics)) {
    for (const auto& list : cut(file, text, diagnostics)) {
      if (list.size() == 1) continue;  // its end alone: what else it held was refused
      if (auto expectation = ExpectationParser(file, list, diagnostics).parse())
        parsed.expectations.push_back(std::move(*expectation));
    }
    if (parsed.expectations.empty() && diagnostics.count() == 0)
      diagnostics.error(
          {file, 1, 1}, "expect/nothing", "the file expects nothing",
          "write a line such as: every robot: never state is \"break_free\" for 20 s");
  }
  parsed.diagnostics = std::move(diagnostics).take({file});
  return parsed;
}

}  // namespace galilean::expect
