// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace galilean {

/// How far the orders of each key have come: the highest number of those that were accepted, by the
/// keys' ids.
using OrderNumbers = std::map<std::string, std::uint64_t>;

/// What is remembered of orders over restarts. Without it, somebody could send an order of before a
/// restart again once the machine's clock was set back.
struct OrderMemory {
  OrderNumbers before{};  ///< as the last start left them
  /// Is called with each order that is accepted. It must not wait. Null: nothing is kept.
  std::function<void(const OrderNumbers&)> keep = nullptr;
};

}  // namespace galilean
