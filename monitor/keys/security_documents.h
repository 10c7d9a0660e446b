// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "monitor/keys/member_role.h"

namespace galilean::monitor {

/// Returns the governance of a team as XML (DDS Security 1.1, 9.4.1.2): in all domains that can be
/// secured nobody joins unauthenticated, topics' names and messages are encrypted, and each packet
/// is signed.
[[nodiscard]] std::string governance_xml();

/// What one member's grant says. Times are seconds since 1970 (UTC).
struct Grant {
  std::string name;     ///< the member's; letters, digits, _ and - alone
  std::string subject;  ///< of its certificate, as RFC 2253 writes it
  TopicRights rights;
  std::int64_t from_s = 0, until_s = 0;
};

/// Returns the grant as XML (DDS Security 1.1, 9.4.1.3), which denies what it does not allow.
[[nodiscard]] std::string permissions_xml(const Grant& grant);

/// Returns a time as the documents write it, and as people and sort(1) read it:
/// 2026-03-01T12:00:00Z.
[[nodiscard]] std::string document_time(std::int64_t since_1970_s);

}  // namespace galilean::monitor
