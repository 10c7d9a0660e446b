// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/orders/signed_writer.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {

/// Sends an operator's orders about break points to robots.
class BreakOrders {
 public:
  /// `signer` signs the orders; null: nobody does.
  explicit BreakOrders(wire::Participant& participant,
                       std::shared_ptr<OrderSigner> signer = nullptr)
      : writer_(participant, wire::kBreakOrderTopic, std::move(signer)) {}

  /// Returns the number of readers of the topic, which is the number of robots that listen.
  [[nodiscard]] int listeners() const { return writer_.readers(); }
  /// Sends an order with its time, its author and a new id. Returns the id, which comes back in the
  /// robots' answers, or an empty string if DDS did not accept the order.
  [[nodiscard]] std::string give(msg::BreakOrder order);

 private:
  SignedWriter<msg::BreakOrder> writer_;
  unsigned long given_ = 0;
};

}  // namespace galilean::monitor
