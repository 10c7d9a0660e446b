// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/order_signer.h"

#include <algorithm>

namespace galilean {

msg::Signature OrderSigner::begin() {
  const std::int64_t now_ns = now_();
  const auto by_clock = static_cast<std::uint64_t>(std::max<std::int64_t>(now_ns, 1));
  std::uint64_t last = last_.load();
  std::uint64_t number = 0;
  do number = std::max(last + 1, by_clock);
  while (!last_.compare_exchange_weak(last, number));
  return {.key_id = id_,
          .number = number,
          .issued_ns = now_ns,
          .expires_ns = now_ns + kLifetime.count(),
          .bytes = {}};
}

}  // namespace galilean
