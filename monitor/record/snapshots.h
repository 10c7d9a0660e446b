// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/clock.h"
#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Says when something happens for whose sake a recording is wanted.
class Trigger {
 public:
  virtual ~Trigger() = default;
  /// Takes a message. Requires: `at` does not fall.
  virtual void take(const wire::EndpointInfo& writer, const wire::Received& received, Time at) = 0;
  /// Returns what has happened since the last call, in words; nothing if nothing has.
  [[nodiscard]] virtual std::optional<std::string> happened() = 0;
};

/// Which part of what is received is written: all, or with a trigger, what came shortly before and
/// after each event.
struct Snapshots {
  Trigger* trigger = nullptr;  ///< outlives the recorder
  Duration before{}, after{};
  std::size_t most_bytes = 64'000'000;  ///< of the messages that are kept for an event
};

}  // namespace galilean::monitor
