// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/clock.h"
#include "core/orders/order_bytes.h"
#include "core/signing/signing_key.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean {

/// Signs an operator's orders. Any thread may call it. Several processes may sign with one key at
/// once: the numbers are the nanoseconds of their clocks, so that they rise over all of them.
class OrderSigner {
 public:
  /// For so long after it was signed a robot carries an order out.
  static constexpr Duration kLifetime = std::chrono::seconds(10);
  /// Returns the time in nanoseconds since the Unix epoch, UTC.
  using WallClock = std::function<std::int64_t()>;

  explicit OrderSigner(SigningKey key, WallClock now = wire::wall_clock_ns)
      : key_(std::move(key)), id_(key_.verifying_key().id()), now_(std::move(now)) {}

  /// Signs the order as one of `topic`. Requires: it is not changed afterwards.
  /// Errors: throws std::runtime_error if OpenSSL cannot sign.
  template <class M>
  void sign(M& order, const std::string& topic) {
    order.signature = begin();
    auto bytes = key_.sign(order_bytes(order, topic));
    if (!bytes) throw std::runtime_error(bytes.error().message);
    order.signature.bytes = std::move(bytes).value();
  }
  [[nodiscard]] const std::string& key_id() const noexcept { return id_; }

 private:
  /// Returns a signature that lacks its bytes.
  [[nodiscard]] msg::Signature begin();

  SigningKey key_;
  std::string id_;
  WallClock now_;
  std::atomic<std::uint64_t> last_{0};
};

}  // namespace galilean
