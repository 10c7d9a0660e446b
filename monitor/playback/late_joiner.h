// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "core/wire/delivery.h"
#include "monitor/mcap/owned_message.h"

namespace galilean::monitor {

/// Keeps of the messages before an instant what a late joiner would have been told then: the newest
/// message of each state and the last 64 of each event.
class LateJoiner {
 public:
  void keep(const mcap::Message& message, wire::Delivery delivery);
  [[nodiscard]] bool empty() const noexcept { return kept_.empty(); }
  /// Calls `take` with each kept message, in the order of their log times, and forgets them.
  template <class Take>
  void give(Take take) {
    for (const auto& each : in_order()) take(each.message());
  }

 private:
  [[nodiscard]] std::vector<mcap::OwnedMessage> in_order();

  std::map<std::uint16_t, std::vector<mcap::OwnedMessage>> kept_;  ///< by channel
};

}  // namespace galilean::monitor
