// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/wire/cdr_writer.h"
#include "core/wire/messages.h"

namespace galilean {

/// Tells signatures of orders from those of anything else that a key may sign.
inline constexpr const char* kOrderPurpose = "galilean order 1";

/// Returns where an order counts: the number of the DDS domain and the topic, as
/// "5/rt/team/command". A robot of the same name in another domain, which may be a simulation,
/// trusts the same key perhaps, and what was ordered to one must not move the other.
[[nodiscard]] inline std::string order_place(std::uint32_t domain, const std::string& topic) {
  return std::to_string(domain) + "/" + topic;
}

/// Returns the bytes that an order's signature signs, as docs/SECURITY.md lists them: the purpose,
/// the place, the order in CDR with an empty signature, the key's id, the targets, the number, and
/// the times of issue and of expiry. They do not depend on the machine, nor on the bytes in which
/// DDS carried the order.
template <class M>
[[nodiscard]] std::vector<std::uint8_t> order_bytes(const M& order, const std::string& place) {
  M body = order;
  body.signature = {};
  const msg::Signature& signature = order.signature;
  msg::CdrWriter to;
  to.write(std::string(kOrderPurpose));
  to.write(place);
  to.write(msg::encode_cdr(body));
  to.write(signature.key_id);
  to.write(order.targets);
  to.write(signature.number);
  to.write(signature.issued_ns);
  to.write(signature.expires_ns);
  return to.take();
}

}  // namespace galilean
