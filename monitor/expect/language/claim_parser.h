// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "monitor/expect/language/condition_parser.h"

namespace galilean::expect {

/// Returns every word that begins a claim, but for those of conditions.
[[nodiscard]] std::span<const std::string_view> claim_words() noexcept;

/// Reads the claims of one expectation.
class ClaimParser {
 public:
  ClaimParser(TokenReader& tokens, bool of_robot) : tokens_(tokens), of_robot_(of_robot) {}

  /// Returns nothing if it reported an error.
  [[nodiscard]] std::optional<Claim> parse();

 private:
  using Kind = decltype(Claim::kind);

  std::optional<Condition> condition();
  std::optional<Kind> parse_kind();
  std::optional<Kind> parse_always();
  std::optional<Kind> parse_never();
  std::optional<Kind> parse_eventually();
  std::optional<Kind> parse_after();
  std::optional<Kind> parse_count();
  std::optional<Kind> parse_rate();
  std::optional<Kind> parse_no();
  std::optional<Kind> parse_losses();
  std::optional<Kind> parse_condition();
  std::optional<Kind> parse_until(Condition held);
  /// Reads `word TIME` where the word stands. Returns false if it reported an error.
  bool optional_time(std::string_view word, std::optional<double>& time_s);

  [[nodiscard]] std::string meant_word() const;

  TokenReader& tokens_;
  bool of_robot_;
  std::optional<TopicName> topic_;  ///< of the newest claim about one
};

}  // namespace galilean::expect
