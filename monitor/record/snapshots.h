// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Says when something happens for whose sake a recording is wanted.
class Trigger {
 public:
  virtual ~Trigger() = default;
  /// Returns whether it needs what this writer sends, which is then heard, recorded or not.
  [[nodiscard]] virtual bool wants(const wire::EndpointInfo& writer) const = 0;
  /// Takes a message. Requires: `at` does not fall.
  virtual void take(const wire::EndpointInfo& writer, const wire::Received& received, Time at) = 0;
  /// Returns what has happened since the last call, in words; nothing if nothing has.
  [[nodiscard]] virtual std::optional<std::string> happened() = 0;
  /// Returns sentences on why something cannot happen, as far as is known now. They may repeat.
  [[nodiscard]] virtual std::vector<std::string> doubts() { return {}; }
};

/// Which part of what is received is written: all, or with a trigger, what came shortly before and
/// after each event.
struct Snapshots {
  Trigger* trigger = nullptr;  ///< outlives the recorder
  Duration before{}, after{};
  std::uint64_t most_bytes = 64'000'000;  ///< of the messages that are kept for an event
};

}  // namespace galilean::monitor
