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
  kJournal,  ///< an event that must reach those, too, who were cut off for some minutes: as kEvent,
             ///< but keep-last kJournalDepth
  kCommand,  ///< a command: reliable, volatile, keep-last 64
  kFlow,     ///< reliable, volatile, keep-last 10, as ROS 2 tools demand of odometry, tf and
             ///< diagnostics
  kRecord,   ///< what must not be lost: reliable, transient-local for the newest 64, keep all, so
             ///< that the writer waits for slow readers
  kStream    ///< best effort, volatile, keep-last 1
};
/// Returns whether messages tell of single events, of which none may be missed.
[[nodiscard]] constexpr bool is_event(Delivery delivery) noexcept {
  return delivery == Delivery::kEvent || delivery == Delivery::kJournal;
}
/// Returns the delivery of a message type. A type that is not in the list is a stream.
[[nodiscard]] Delivery delivery_of(std::string_view ros_type) noexcept;

/// How many of its newest messages the writer of a journal keeps in memory. A robot that changes
/// its state three times a second fills that in five minutes. DDS hands them to each reader that it
/// connects anew, so that one who was cut off hears what happened meanwhile.
inline constexpr int kJournalDepth = 1024;

/// Returns how many of a writer's newest messages tell a late joiner how things stand. The writer
/// of a journal keeps more of them, for those who were cut off.
[[nodiscard]] constexpr std::size_t kept_for_late_joiners(Delivery delivery) noexcept {
  if (delivery == Delivery::kState) return 1;
  return is_event(delivery) ? 64 : 0;
}

}  // namespace galilean::wire
