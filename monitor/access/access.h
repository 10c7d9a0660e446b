// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/access/named_tokens.h"
#include "monitor/access/right.h"
#include "monitor/access/tokens.h"

namespace galilean::monitor {

/// The names of the tokens that every monitor has. No named token is called so.
inline constexpr std::string_view kOperatorAccount = "operator", kViewerAccount = "viewer";

/// Decides what the bearer of a token may do. An operator's token gives the right to read and to
/// steer, a viewer's token the right to read. With `reads_freely`, reading needs no token.
class Access {
 public:
  /// Returns the wall clock [s since 1970], by which named tokens expire.
  using Now = std::function<std::int64_t()>;

  Access(const Tokens& tokens, bool reads_freely, Now now_s = wall_clock_s);

  /// Replaces the named tokens. Those of the constructor stay.
  void set_named(std::vector<NamedToken> named) { named_ = std::move(named); }

  /// Returns the right that a token gives; an empty string stands for no token. The time that this
  /// takes does not tell how much of a wrong token is right.
  [[nodiscard]] Right right_of(std::string_view token) const;
  /// Returns the right that a token gives where reading needs one, too.
  [[nodiscard]] Right right_by_token(std::string_view token) const;
  /// The same for the digest_of() a token.
  [[nodiscard]] Right right_by_digest(std::string_view digest) const;
  /// Returns the name of the token with this digest: kOperatorAccount, kViewerAccount or that of a
  /// named token. It is empty if the token gives no right.
  [[nodiscard]] std::string account_by_digest(std::string_view digest) const;
  /// Returns the right of somebody without a token.
  [[nodiscard]] Right free_right() const noexcept {
    return reads_freely_ ? Right::kRead : Right::kNone;
  }

 private:
  std::string viewer_sha256_, operator_sha256_;
  std::vector<NamedToken> named_;
  bool reads_freely_;
  Now now_s_;
};

/// Returns whether an address can be reached from this machine only.
[[nodiscard]] bool is_loopback(const std::string& address);

/// Returns the sentence for a request that lacks a right: which token it needs, and how to send it.
[[nodiscard]] std::string missing_right(Right needed);

}  // namespace galilean::monitor
