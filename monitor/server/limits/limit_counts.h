// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace galilean::monitor {

/// A bound that clients can reach.
enum class Limit : std::uint8_t {
  kConnections,
  kConnectionsOfAddress,
  kDescriptors,
  kHeaders,
  kBody,
  kBodies,
  kChecks,
  kRecordings,
  kCommands,
  kPings,
  kMessage,
  kMessages,
  kSubscriptions,
  kCalls,
  kWaitingEvents,
  kWaitingEventsOfAll,
};
inline constexpr std::size_t kLimitCount = 16;

/// Counts how often each limit was reached, and writes to stderr when one is for the first time.
/// May be used from any thread.
class LimitCounts {
 public:
  void reached(Limit limit);
  [[nodiscard]] std::uint64_t count(Limit limit) const noexcept;
  /// Returns the limit's name in /metrics, such as "pings".
  [[nodiscard]] static std::string_view name(Limit limit) noexcept;

 private:
  std::array<std::atomic<std::uint64_t>, kLimitCount> counts_{};
};

}  // namespace galilean::monitor
