// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/orders/order_signer.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"

namespace galilean {

/// Writes orders to one topic, signed if there is a signer. Without one they are written as they
/// are, and robots that were started with --trust take only those of them that stop.
template <class M>
class SignedWriter {
 public:
  /// `signer` may be null. Errors: throws std::runtime_error if DDS refuses the topic.
  SignedWriter(wire::Participant& participant, const std::string& topic,
               std::shared_ptr<OrderSigner> signer)
      : place_(order_place(participant.domain(), topic)),
        signer_(std::move(signer)),
        writer_(participant, topic) {}

  /// Returns false if DDS did not take the order in time. It is then lost. Errors: throws
  /// std::runtime_error if it cannot be signed.
  [[nodiscard]] bool write(M order) {
    if (signer_) signer_->sign(order, place_);
    return writer_.write(order);
  }
  [[nodiscard]] int readers() const { return writer_.readers(); }

 private:
  std::string place_;
  std::shared_ptr<OrderSigner> signer_;
  wire::Writer<M> writer_;
};

}  // namespace galilean
