// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/access.h"

#include <arpa/inet.h>

#include <algorithm>

namespace galilean::monitor {
namespace {

/// Compares in a time that does not depend on how many characters agree, so that the time does not
/// help to guess a token.
bool same(std::string_view given, std::string_view secret) noexcept {
  unsigned difference = given.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < secret.size(); ++i)
    difference |= static_cast<unsigned char>(secret[i]) ^
                  static_cast<unsigned char>(given.empty() ? 0 : given[i % given.size()]);
  return difference == 0;
}

}  // namespace

Right Access::right_by_token(std::string_view token) const noexcept {
  const bool operates = same(token, tokens_.operator_);
  const bool reads = same(token, tokens_.viewer);
  if (operates) return Right::kOperate;
  return reads ? Right::kRead : Right::kNone;
}

Right Access::right_of(std::string_view token) const noexcept {
  return std::max(right_by_token(token), reads_freely_ ? Right::kRead : Right::kNone);
}

bool is_loopback(const std::string& address) {
  in_addr v4{};
  if (inet_pton(AF_INET, address.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24) == 127;
  return address == "localhost" || address == "::1";
}

std::string missing_right(Right needed) {
  const std::string whose = needed == Right::kOperate ? "operator" : "viewer";
  return "This needs the " + whose + "'s token, which is in " + whose +
         ".token in the monitor's data folder: open the page as http://…/#token=TOKEN, or send " +
         "'Authorization: Bearer TOKEN'.";
}

}  // namespace galilean::monitor
