// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/operator_id.h"

#include "core/account.h"
#include "core/cut_text.h"
#include "core/visible_text.h"
#include "monitor/access/access.h"

namespace galilean::monitor {
namespace {

std::string shown(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(cut_text(visible(cut_text(text, kMostOperatorBytes)), kMostOperatorBytes));
}

std::string name_without_claim(const std::string& account, const std::string& address) {
  const bool is_of_person = !account.empty() && account != kOperatorAccount;
  if (is_of_person) return account;
  return is_loopback(address) ? user_name() : address;
}

}  // namespace

OperatorId operator_id(std::string_view name, std::string_view client, const std::string& account,
                       const std::string& address) {
  OperatorId id{.name = shown(name), .account = account, .client = shown(client)};
  if (id.name.empty()) id.name = name_without_claim(account, address);
  return id;
}

}  // namespace galilean::monitor
