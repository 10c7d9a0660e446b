// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <utility>

#include "core/wire/entity.h"

namespace galilean::wire {

/// Owns the entity of a writer. The destructor waits until the readers have acknowledged what was
/// written, but only until kLinger after the newest message: a reader that was killed stays matched
/// until its lease of ten seconds ends, and acknowledges nothing. Cyclone would wait as long, but
/// from the deletion on, so that a process with ten writers would take ten times as long to end.
class LingeringEntity {
 public:
  /// Cyclone repeats what was lost within a tenth of a second.
  static constexpr std::chrono::seconds kLinger{1};

  explicit LingeringEntity(Entity entity) noexcept : entity_(std::move(entity)) {}
  LingeringEntity(LingeringEntity&& other) noexcept;
  ~LingeringEntity();
  [[nodiscard]] std::int32_t handle() const noexcept { return entity_.handle(); }
  /// Tells that a message was written now. Any thread may call it.
  void note_written() noexcept;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::time_point kNever = Clock::time_point::min();
  Entity entity_;
  std::atomic<Clock::time_point> written_{kNever};
};

}  // namespace galilean::wire
