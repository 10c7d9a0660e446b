// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/lingering_entity.h"

#include <dds/dds.h>

namespace galilean::wire {

LingeringEntity::LingeringEntity(LingeringEntity&& other) noexcept
    : entity_(std::move(other.entity_)), written_(other.written_.load()) {}

LingeringEntity::~LingeringEntity() {
  const auto written = written_.load();
  if (handle() <= 0 || written == kNever) return;
  const std::chrono::nanoseconds left = written + kLinger - Clock::now();
  if (left.count() > 0) static_cast<void>(dds_wait_for_acks(handle(), left.count()));
}

void LingeringEntity::note_written() noexcept {
  written_.store(Clock::now(), std::memory_order_relaxed);
}

}  // namespace galilean::wire
