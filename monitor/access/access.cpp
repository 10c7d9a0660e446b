// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/access.h"

#include <arpa/inet.h>

#include <algorithm>
#include <utility>

#include "monitor/access/digest.h"

namespace galilean::monitor {

Access::Access(const Tokens& tokens, bool reads_freely, Now now_s)
    : viewer_sha256_(digest_of(tokens.viewer)),
      operator_sha256_(digest_of(tokens.operator_)),
      reads_freely_(reads_freely),
      now_s_(std::move(now_s)) {}

Right Access::right_by_digest(std::string_view digest) const {
  const auto now_s = now_s_();
  Right right = Right::kNone;
  const auto compare = [&](std::string_view known, Right gives) {
    if (is_same_digest(digest, known)) right = std::max(right, gives);
  };
  compare(viewer_sha256_, Right::kRead);
  compare(operator_sha256_, Right::kOperate);
  for (const auto& token : named_)  // all of them, so that the time tells nothing
    compare(token.sha256, token.is_expired(now_s) ? Right::kNone : token.right);
  return right;
}

std::string Access::account_by_digest(std::string_view digest) const {
  const auto now_s = now_s_();
  std::string account;
  if (is_same_digest(digest, viewer_sha256_)) account = kViewerAccount;
  if (is_same_digest(digest, operator_sha256_)) account = kOperatorAccount;
  for (const auto& token : named_)
    if (is_same_digest(digest, token.sha256) && !token.is_expired(now_s)) account = token.name;
  return account;
}

Right Access::right_by_token(std::string_view token) const {
  return token.empty() ? Right::kNone : right_by_digest(digest_of(token));
}

Right Access::right_of(std::string_view token) const {
  return std::max(right_by_token(token), free_right());
}

bool is_loopback(const std::string& address) {
  in_addr v4{};
  if (inet_pton(AF_INET, address.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24) == 127;
  return address == "localhost" || address == "::1";
}

std::string missing_right(Right needed) {
  const std::string whose = needed == Right::kOperate ? "operator" : "viewer";
  return "This needs the " + whose + "'s token, which is in " + whose +
         ".token in the monitor's data folder, or one that 'galilean tokens add' gave: open the " +
         "page as http://…/#token=TOKEN, or send 'Authorization: Bearer TOKEN'.";
}

}  // namespace galilean::monitor
