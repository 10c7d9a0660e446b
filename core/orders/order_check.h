// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/orders/order_bytes.h"
#include "core/orders/order_memory.h"
#include "core/orders/replay_window.h"
#include "core/result.h"
#include "core/signing/trusted_keys.h"
#include "core/wire/messages.h"

namespace galilean {

/// Why an order is not carried out.
struct OrderRefusal {
  enum class Kind { kUntrusted, kBroken, kReplayed, kExpired, kEarly, kOfBefore };
  Kind kind;
  std::string why;  ///< it stands behind "was refused: "
};

/// Returns why, and what to do, for the one who gave the order.
[[nodiscard]] std::string with_advice(const OrderRefusal& refusal);

/// The time of a machine that checks orders.
struct CheckTimes {
  std::int64_t now_ns;     ///< since the Unix epoch, UTC
  std::int64_t uptime_ns;  ///< since it began to check, by a clock that nobody sets
};

/// Decides whether orders are signed by a trusted key, are of now, and come for the first time.
/// One thread at a time may use it.
class OrderCheck {
 public:
  /// The clocks of who signs and who checks may differ by so much.
  static constexpr Duration kClockTolerance = std::chrono::seconds(5);

  /// `before` is what numbers() returned before a restart: whatever is not above it is refused,
  /// however the clocks were set meanwhile.
  explicit OrderCheck(TrustedKeys trusted, OrderNumbers before = {})
      : trusted_(std::move(trusted)), before_(before), highest_(std::move(before)) {}

  /// Takes in an order that came at this order_place(). Requires: it is meant for this machine.
  /// Errors: it is not to be carried out. An order that was accepted is refused when it comes
  /// again.
  template <class M>
  [[nodiscard]] Result<void, OrderRefusal> accept(const M& order, const std::string& place,
                                                  const CheckTimes& times) {
    return accept(
        order.signature, [&] { return order_bytes(order, place); }, times);
  }

  /// Returns the highest numbers that were accepted, now or before.
  [[nodiscard]] const OrderNumbers& numbers() const noexcept { return highest_; }

 private:
  /// The bytes are asked for only where the rest is right: who is not trusted costs no more.
  using Bytes = std::function<std::vector<std::uint8_t>()>;
  [[nodiscard]] Result<void, OrderRefusal> accept(const msg::Signature& signature,
                                                  const Bytes& bytes, const CheckTimes& times);
  /// Errors: an order of this key and this number has come, or may have.
  [[nodiscard]] Result<void, OrderRefusal> take_number(const std::string& key_id,
                                                       std::uint64_t number);

  TrustedKeys trusted_;
  const OrderNumbers before_;
  OrderNumbers highest_;
  std::map<std::string, ReplayWindow> seen_;  ///< by the keys' ids
};

}  // namespace galilean
