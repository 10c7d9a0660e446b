// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// A message with its own bytes.
struct OwnedMessage {
  Message head;  ///< its data is in `data`
  Bytes data;

  [[nodiscard]] static OwnedMessage of(const Message& message) {
    return {message, {message.data.begin(), message.data.end()}};
  }
  /// Returns the message. Its data is valid as long as this.
  [[nodiscard]] Message message() const {
    auto whole = head;
    whole.data = data;
    return whole;
  }
};

}  // namespace galilean::mcap
