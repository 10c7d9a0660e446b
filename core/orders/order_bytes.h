// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/wire/cdr_writer.h"
#include "core/wire/messages.h"

namespace galilean {

/// Tells signatures of orders from those of anything else that a key may sign.
inline constexpr const char* kOrderDomain = "galilean order 1";

/// Returns the bytes that an order's signature signs, as docs/SECURITY.md lists them: the domain,
/// the topic, the order in CDR with an empty signature, the key's id, the targets, the number, and
/// the times of issue and of expiry. They do not depend on the machine, nor on the bytes in which
/// DDS carried the order.
template <class M>
[[nodiscard]] std::vector<std::uint8_t> order_bytes(const M& order, const std::string& topic) {
  M body = order;
  body.signature = {};
  const msg::Signature& signature = order.signature;
  msg::CdrWriter to;
  to.write(std::string(kOrderDomain));
  to.write(topic);
  to.write(msg::encode_cdr(body));
  to.write(signature.key_id);
  to.write(order.targets);
  to.write(signature.number);
  to.write(signature.issued_ns);
  to.write(signature.expires_ns);
  return to.take();
}

}  // namespace galilean
