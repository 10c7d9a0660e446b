// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/clock.h"
#include "core/orders/number_file.h"
#include "core/orders/order_bytes.h"
#include "core/orders/stopping_orders.h"
#include "core/signing/signing_key.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean {

/// Signs an operator's orders. Any thread may call it. Several processes may sign with one key at
/// once: the numbers are the nanoseconds of their clocks, so that they rise over all of them. Where
/// a clock was set back, they go on from those in the key's NumberFile.
class OrderSigner {
 public:
  /// For so long after it was signed a robot carries an order out.
  static constexpr Duration kLifetime = std::chrono::seconds(10);
  /// Returns the time in nanoseconds since the Unix epoch, UTC.
  using WallClock = std::function<std::int64_t()>;

  /// `numbers` is the key's number_file(). If it is empty, numbers begin with the clock's.
  explicit OrderSigner(SigningKey key, WallClock now = wire::wall_clock_ns,
                       const std::filesystem::path& numbers = {})
      : key_(std::move(key)), id_(key_.verifying_key().id()), now_(std::move(now)) {
    if (!numbers.empty()) numbers_.emplace(numbers);
  }

  /// Signs the order for this order_place(). Requires: it is not changed afterwards.
  /// Errors: throws std::runtime_error if OpenSSL cannot sign.
  template <class M>
  void sign(M& order, const std::string& place) {
    bool stops = false;
    if constexpr (requires { only_stops(order); }) stops = only_stops(order);
    order.signature = begin(!stops);
    auto bytes = key_.sign(order_bytes(order, place));
    if (!bytes) throw std::runtime_error(bytes.error().message);
    order.signature.bytes = std::move(bytes).value();
  }
  [[nodiscard]] const std::string& key_id() const noexcept { return id_; }

 private:
  /// Returns a signature that lacks its bytes. With `of_file` its number is above those that the
  /// key's file knows. An order to stop does without, because a disk may hang, and robots obey such
  /// an order whatever its number is.
  [[nodiscard]] msg::Signature begin(bool of_file);
  [[nodiscard]] std::uint64_t next_number(std::int64_t now_ns, bool of_file);

  SigningKey key_;
  std::string id_;
  WallClock now_;
  std::optional<NumberFile> numbers_;
  std::atomic<std::uint64_t> last_{0};
};

}  // namespace galilean
