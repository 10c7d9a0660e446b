// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/order_signer.h"

#include <algorithm>

namespace galilean {

msg::Signature OrderSigner::begin(bool of_file) {
  const std::int64_t now_ns = now_();
  return {.key_id = id_,
          .number = next_number(now_ns, of_file),
          .issued_ns = now_ns,
          .expires_ns = now_ns + kLifetime.count(),
          .bytes = {}};
}

std::uint64_t OrderSigner::next_number(std::int64_t now_ns, bool of_file) {
  const auto by_clock = static_cast<std::uint64_t>(std::max<std::int64_t>(now_ns, 1));
  std::uint64_t last = last_.load();
  std::uint64_t number = 0;
  do number = std::max(last + 1, by_clock);
  while (!last_.compare_exchange_weak(last, number));
  if (!numbers_ || !of_file) return number;
  number = numbers_->take(number);
  // No thread of this process goes below it from now on.
  while (last < number && !last_.compare_exchange_weak(last, number)) {
  }
  return number;
}

}  // namespace galilean
