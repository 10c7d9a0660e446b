// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "monitor/access/tokens.h"

namespace galilean::monitor {

enum class Right { kNone, kRead, kOperate };

/// Decides what the bearer of a token may do. The operator's token gives the right to read and to
/// steer, the viewer's token the right to read. With `reads_freely`, reading needs no token.
class Access {
 public:
  Access(Tokens tokens, bool reads_freely)
      : tokens_(std::move(tokens)), reads_freely_(reads_freely) {}

  /// Returns the right that a token gives; an empty string stands for no token. The time that this
  /// takes does not tell how much of a wrong token is right.
  [[nodiscard]] Right right_of(std::string_view token) const noexcept;
  /// Returns the right that a token gives where reading needs one, too.
  [[nodiscard]] Right right_by_token(std::string_view token) const noexcept;

 private:
  Tokens tokens_;
  bool reads_freely_;
};

/// Returns whether an address can be reached from this machine only.
[[nodiscard]] bool is_loopback(const std::string& address);

/// Returns the sentence for a request that lacks a right: which token it needs, and how to send it.
[[nodiscard]] std::string missing_right(Right needed);

}  // namespace galilean::monitor
