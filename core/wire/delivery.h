// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace galilean::wire {

/// How a kind of message travels. The type of the message decides it, in qos.cpp.
enum class Delivery {
  kState,    ///< a present state: reliable, transient-local, keep-last 1; a late joiner gets it at
             ///< once
  kEvent,    ///< an event: reliable, transient-local, keep-last 64; events are numbered, so that
             ///< receivers drop repeats
  kCommand,  ///< a command: reliable, volatile, keep-last 64
  kFlow,     ///< reliable, volatile, keep-last 10, as ROS 2 tools demand of odometry, tf and
             ///< diagnostics
  kRecord,   ///< what must not be lost: reliable, transient-local for the newest 64, keep all, so
             ///< that the writer waits for slow readers
  kStream    ///< best effort, volatile, keep-last 1
};
/// Returns the delivery of a message type. A type that is not in the list is a stream.
[[nodiscard]] Delivery delivery_of(std::string_view ros_type) noexcept;

/// Returns how many of a writer's newest messages a late joiner gets.
[[nodiscard]] constexpr std::size_t kept_for_late_joiners(Delivery delivery) noexcept {
  if (delivery == Delivery::kState) return 1;
  return delivery == Delivery::kEvent ? 64 : 0;
}

}  // namespace galilean::wire
