// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/order_author.h"

#include <string_view>

#include "monitor/access/access.h"

namespace galilean::monitor {
namespace {

constexpr std::string_view kAnyOperator = "operator";

/// Returns whether the text is this name, alone or with a reason in brackets behind it.
bool begins_with_name(std::string_view text, std::string_view name) {
  if (!text.starts_with(name)) return false;
  const std::string_view rest = text.substr(name.size());
  return rest.empty() || rest.starts_with(" (");
}

}  // namespace

std::string author_of(const std::string& said, const OperatorId& sender) {
  std::string author = said.empty() ? sender.name : said;
  if (begins_with_name(said, kAnyOperator)) author = sender.name + said.substr(kAnyOperator.size());
  const std::string& account = sender.account;
  const bool is_of_person =
      !account.empty() && account != kOperatorAccount && account != kViewerAccount;
  if (!is_of_person || begins_with_name(author, account)) return author;
  return author + ", with the token of " + account;
}

}  // namespace galilean::monitor
