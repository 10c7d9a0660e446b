// SPDX-License-Identifier: BSD-3-Clause
// What a request's token permits, also while the answer is under way.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "monitor/access/digest.h"
#include "monitor/server/http/http_connection.h"

namespace galilean::monitor {

/// Looks up what the request's token gives, and notes that for later.
Right HttpConnection::right_of(const HttpRequest& request) {
  const Access& access = context_->access;
  digest_ = request.token.empty() ? std::string() : digest_of(request.token);
  token_right_ = digest_.empty() ? Right::kNone : access.right_by_digest(digest_);
  return context_->guard.is_of_stranger(request) ? token_right_
                                                 : std::max(token_right_, access.free_right());
}

/// Requires: right_of(request) was called.
OperatorId HttpConnection::sender_of(const HttpRequest& request) const {
  const auto account = digest_.empty() ? "" : context_->access.account_by_digest(digest_);
  return operator_id(request.operator_name, request.client, account, address_);
}

/// Returns how long a client must wait whose token is wrong, if it has sent too many such tokens.
std::optional<Duration> HttpConnection::held_off() {
  if (digest_.empty() || token_right_ != Right::kNone) return {};
  ++context_->counts.wrong_tokens;
  const auto verdict = context_->guesses.note_wrong(address_, digest_, context_->clock.now());
  if (verdict.wait <= Duration::zero()) return {};
  ++context_->counts.held_off;
  if (verdict.is_first)
    std::clog << "galilean-monitor: " << address_
              << " sends too many wrong tokens and is told to wait" << std::endl;
  return verdict.wait;
}

/// Returns whether the request's token was revoked or has expired since the request came.
bool HttpConnection::is_withdrawn() const {
  return token_right_ != Right::kNone && context_->access.right_by_digest(digest_) < token_right_;
}

HttpResponse HttpConnection::too_many_guesses(Duration wait) {
  const auto seconds = static_cast<std::int64_t>(std::ceil(to_seconds(wait)));
  auto response =
      problem(429, "Too many wrong tokens came from this address: try again in " +
                       std::to_string(seconds) + " s. A right token passes at any time.");
  response.headers.emplace_back("Retry-After", std::to_string(seconds));
  return response;
}

}  // namespace galilean::monitor
